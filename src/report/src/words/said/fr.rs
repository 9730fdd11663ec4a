//! What a diagnosis says, in French.

/// The English text and its translation.
pub const FR: &[(&str, &str)] = &[
    // Lists.
    (", ", ", "),
    (" and ", " et "),
    // The answer.
    (
        "{times} times the error that noise and the form of curves leave",
        "{times} fois l’écart que laissent le bruit et la forme des courbes",
    ),
    ("{effect} ({percent} sure)", "{effect} (sûr à {percent})"),
    (
        "missing: {names}; what is left falls from {before} to {after} times",
        "il manque : {names} ; ce qui reste passe de {before} à {after} fois",
    ),
    (
        "{percent} of the disagreement is not explained by what was named: another form of it, or something else",
        "{percent} du désaccord ne sont pas expliqués par ce qui a été nommé : une autre forme, ou autre chose",
    ),
    ("{test} ({times} times)", "{test} ({times} fois)"),
    (
        "too rare or too small to be named, but these tests are missed: {tests}",
        "trop rare ou trop petit pour être nommé, mais ces essais sont manqués : {tests}",
    ),
    (
        "nothing is missing that these records can show ({percent} sure): the model is off by {times}{not_seen}{not_confirmed}",
        "il ne manque rien que ces mesures puissent montrer (sûr à {percent}) : le modèle s’écarte de {times}{not_seen}{not_confirmed}",
    ),
    ("; they cannot show {names}", " ; elles ne peuvent montrer {names}"),
    ("; no test was left out to confirm it", " ; aucun essai n’a été mis de côté pour le confirmer"),
    (
        "something is missing: the model is off by {times}, and {why}{place}",
        "il manque quelque chose : le modèle s’écarte de {times}, et {why}{place}",
    ),
    (
        "{effect} is the likeliest name, but too few tests speak for it to give it",
        "{effect} est le nom le plus probable, mais trop peu d’essais parlent pour lui pour le donner",
    ),
    ("these records cannot tell {names} apart", "ces mesures ne peuvent distinguer {names}"),
    ("; it acts in the path \"{path}\" ({percent})", " ; il agit dans le chemin « {path} » ({percent})"),
    (
        "the model is off by {times}, and none of the known effects is likely enough to explain that{nearest}",
        "le modèle s’écarte de {times}, et aucun des effets connus n’est assez probable pour l’expliquer{nearest}",
    ),
    ("; it looks like {what}, which explains {percent}", " ; cela ressemble à {what}, ce qui explique {percent}"),
    ("; the nearest, {effect}, explains {percent}", " ; le plus proche, {effect}, explique {percent}"),
    ("explains {percent} of the disagreement", "explique {percent} du désaccord"),
    (
        "explains {percent} of the disagreement, with numbers that dampers hardly show",
        "explique {percent} du désaccord, avec des nombres que les amortisseurs ne montrent guère",
    ),
    // What a disagreement without a name looks like.
    (
        "friction that grows with the force, as a tilted cross-head or eye makes in the guides",
        "un frottement qui croît avec l’effort, comme en fait dans les guides une traverse ou un œil de travers",
    ),
    (
        "a loop over force whatever the speed, as a load cell with hysteresis draws",
        "une boucle selon l’effort quelle que soit la vitesse, comme en trace un capteur d’effort à hystérésis",
    ),
    (
        "a resonance in the path of the force, as of a frame or of oil in a hose",
        "une résonance dans le chemin de l’effort, comme celle d’un bâti ou de l’huile dans un flexible",
    ),
    // Regions.
    (
        "{direction}, {slow}–{fast} m/s{phase}, {place}: {missing} (rms {rms} N, noise {noise} N)",
        "{direction}, {slow}–{fast} m/s{phase}, {place} : {missing} (efficace {rms} N, bruit {noise} N)",
    ),
    ("rebound", "détente"),
    ("compression", "compression"),
    (" while it speeds up", " en accélérant"),
    (" while it slows down", " en ralentissant"),
    ("in all tests that go there", "dans tous les essais qui y passent"),
    ("in test {test}", "dans l’essai {test}"),
    (
        "measured force is {mean} N ± {error} more tensile than computed",
        "l’effort mesuré est de {mean} N ± {error} plus en traction que le calculé",
    ),
    (
        "measured force is {mean} N ± {error} more compressive than computed",
        "l’effort mesuré est de {mean} N ± {error} plus en compression que le calculé",
    ),
    ("{rms} N rms off in both senses", "{rms} N efficaces d’écart dans les deux sens"),
    // Tests that would tell more.
    (
        "run a sine of {amplitude} mm at {frequency} Hz{about}{under}: {a} and {b} differ there by {difference} N rms",
        "passer un sinus de {amplitude} mm à {frequency} Hz{about}{under} : {a} et {b} y diffèrent de {difference} N efficaces",
    ),
    (" about {mean} mm", " autour de {mean} mm"),
    (" under {force} N side force", " sous {force} N d’effort latéral"),
    ("{effect} shows best in: {remedy}", "{effect} se montre le mieux ainsi : {remedy}"),
    (
        "at a usual strength it would leave no trace in these tests: {remedy}",
        "à une force habituelle, il ne laisserait pas de trace dans ces essais : {remedy}",
    ),
    (
        "the tube widens in proportion to pressure like the oil column yields: a rig shows their sum, which oil_compressibility stands for",
        "le tube s’élargit avec la pression comme cède la colonne d’huile : un banc montre leur somme, que représente oil_compressibility",
    ),
    // The test that shows an effect best.
    ("more amplitudes and frequencies", "plus d’amplitudes et de fréquences"),
    (
        "slow triangles at 0.5 to 30 mm/s, two strokes, two temperatures",
        "triangles lents de 0.5 à 30 mm/s, deux courses, deux températures",
    ),
    (
        "stroke the whole travel slowly, and once at 1 Hz, at two mean positions",
        "parcourir lentement toute la course, et une fois à 1 Hz, à deux positions moyennes",
    ),
    ("0.05 to 0.5 mm sines at 1 to 30 Hz", "sinus de 0.05 à 0.5 mm de 1 à 30 Hz"),
    (
        "read the force at rest, with and without the damper hooked in",
        "lire l’effort au repos, avec et sans l’amortisseur accroché",
    ),
    (
        "strokes of 0.1 to 2 mm at 0.1 and 1 Hz: equal loops speak for it",
        "courses de 0.1 à 2 mm à 0.1 et 1 Hz : des boucles égales parlent pour lui",
    ),
    ("the same sine at 0, 500 and 1000 N side force", "le même sinus sous 0, 500 et 1000 N d’effort latéral"),
    (
        "one peak velocity at several strokes and frequencies, at two mean positions",
        "une même vitesse de pointe à plusieurs courses et fréquences, à deux positions moyennes",
    ),
    ("one test after a night's rest and after 200 cycles", "un essai après une nuit de repos et après 200 cycles"),
    (
        "one peak velocity at several strokes, with the gas pressure raised",
        "une même vitesse de pointe à plusieurs courses, avec la pression de gaz augmentée",
    ),
    (
        "a reference test repeated cold and hot, in shuffled order, with the temperature recorded",
        "un essai de référence répété à froid et à chaud, en ordre mélangé, avec la température enregistrée",
    ),
    ("5 to 10 mm sines at five or more mean positions", "sinus de 5 à 10 mm à cinq positions moyennes ou plus"),
    ("push slowly into the stop, then at two speeds", "pousser lentement dans la butée, puis à deux vitesses"),
    ("pull slowly into the stop, then at two speeds", "tirer lentement dans la butée, puis à deux vitesses"),
    (
        "small strokes with a preload that keeps the force from crossing zero, and without",
        "de petites courses avec une précharge qui empêche l’effort de passer par zéro, et sans",
    ),
    ("one peak velocity at 0.5, 1, 2, 5 and 10 Hz", "une même vitesse de pointe à 0.5, 1, 2, 5 et 10 Hz"),
    (
        "slow ramps of velocity through the knee, up and down",
        "des rampes de vitesse lentes à travers le coude, en montant et en descendant",
    ),
    ("run the rig without the damper", "faire tourner le banc sans l’amortisseur"),
    (
        "run a spring in place of the damper: its loop must close",
        "passer un ressort à la place de l’amortisseur : sa boucle doit se fermer",
    ),
    (
        "repeat a reference test at the start, middle and end",
        "répéter un essai de référence au début, au milieu et à la fin",
    ),
    // Why records cannot show an effect.
    (
        "it is part of the series path: the model needs series_compliance first",
        "il fait partie du chemin en série : le modèle a d’abord besoin de series_compliance",
    ),
    (
        "a free FV curve takes a v² term up: it needs the curve fixed by a specification",
        "une courbe FV libre absorbe un terme en v² : il faut que la courbe soit fixée par une spécification",
    ),
    (
        "the side force does not vary: run the same sine under two or more side forces, with the channel recorded",
        "l’effort latéral ne varie pas : passer le même sinus sous deux efforts latéraux ou plus, en enregistrant la voie",
    ),
    (
        "no temperature channel varies, and the records' clocks show no heating: record the oil or tube temperature, or repeat one test cold and after hard work",
        "aucune voie de température ne varie, et les horloges des mesures ne montrent pas d’échauffement : enregistrer la température de l’huile ou du tube, ou répéter un essai à froid et après un dur travail",
    ),
    (
        "all tests pass the same places at the same speeds: run one small sine at five or more mean positions, or one peak velocity at several strokes",
        "tous les essais passent aux mêmes endroits aux mêmes vitesses : passer un petit sinus à cinq positions moyennes ou plus, ou une même vitesse de pointe à plusieurs courses",
    ),
    (
        "only within the {reach} mm of compression that the tests reach: push slowly further to see a stop beyond",
        "seulement dans les {reach} mm de compression que les essais atteignent : pousser lentement plus loin pour voir une butée au-delà",
    ),
    (
        "only within the {reach} mm of extension that the tests reach: pull slowly further to see a stop beyond",
        "seulement dans les {reach} mm de détente que les essais atteignent : tirer lentement plus loin pour voir une butée au-delà",
    ),
    (
        "the tests' frequencies are nearly the same: run one peak velocity at 0.5, 1, 2, 5 and 10 Hz",
        "les fréquences des essais sont presque les mêmes : passer une même vitesse de pointe à 0.5, 1, 2, 5 et 10 Hz",
    ),
    (
        "a zero error of the load cell and the gas force are the same constant: read the load cell with the damper unhooked, before and after",
        "une erreur de zéro du capteur d’effort et l’effort du gaz sont la même constante : lire le capteur avec l’amortisseur décroché, avant et après",
    ),
    (
        "every record starts its clock anew: keep one clock through the campaign and repeat a reference test",
        "chaque mesure remet son horloge à zéro : garder une seule horloge pendant la campagne et répéter un essai de référence",
    ),
    // How the comparison was made.
    (
        "without a reference campaign a name may stand for what is always wrong in the form of the model; where a good damper was measured on the same rig, --reference asks what changed",
        "sans campagne de référence, un nom peut représenter ce qui est toujours faux dans la forme du modèle ; là où un bon amortisseur a été mesuré sur le même banc, --reference demande ce qui a changé",
    ),
    (
        "compared with the reference campaign: what the model leaves of the same tests there is taken out{aside}",
        "comparé à la campagne de référence : ce que le modèle y laisse des mêmes essais est retiré{aside}",
    ),
    (
        "; {count} tests have no counterpart there and were left aside: {tests}",
        " ; {count} essais n’y ont pas d’équivalent et ont été laissés de côté : {tests}",
    ),
    // Where in the way of the force an effect acts.
    ("gas and springs", "gaz et ressorts"),
    ("friction", "frottement"),
    ("series", "en série"),
    ("hydraulic", "hydraulique"),
    ("rig", "banc"),
    ("nothing", "rien"),
    ("something else", "autre chose"),
    // Families of effects.
    ("constant force", "effort constant"),
    ("spring", "ressort"),
    ("dry friction", "frottement sec"),
    ("viscous friction", "frottement visqueux"),
    ("friction under load", "frottement sous charge"),
    ("mount", "fixation"),
    ("oil column", "colonne d’huile"),
    ("void", "vide"),
    ("oil temperature", "température de l’huile"),
    ("valves", "clapets"),
    ("stop", "butée"),
    ("mass", "masse"),
    ("timing", "synchronisation"),
    ("load cell", "capteur d’effort"),
    // What an effect is.
    ("constant gas force", "effort de gaz constant"),
    (
        "growth of the gas force with the displacement of the rod, slow to fast",
        "croissance de l’effort du gaz avec la course de la tige, du lent au rapide",
    ),
    ("dry friction of constant level, F_s tanh(K v)", "frottement sec de niveau constant, F_s tanh(K v)"),
    ("dry friction with a break-away peak", "frottement sec avec pic de décollement"),
    (
        "friction that turns over within a short travel after each reversal (Dahl)",
        "frottement qui s’inverse sur une courte course après chaque inversion (Dahl)",
    ),
    ("viscous friction, F_v v|v|", "frottement visqueux, F_v v|v|"),
    ("dry friction proportional to side force", "frottement sec proportionnel à l’effort latéral"),
    (
        "series spring and damper with the internal mass (compressibility of gas, oil and mount)",
        "ressort et amortisseur en série avec la masse interne (souplesse du gaz, de l’huile et de la fixation)",
    ),
    (
        "rubber in line with the damper: the series spring hardens and loses energy; needs series_compliance",
        "caoutchouc en ligne avec l’amortisseur : le ressort en série durcit et perd de l’énergie ; nécessite series_compliance",
    ),
    (
        "spring parallel to the primary damper: linear, quadratic, cubic, quartic or lookup",
        "ressort en parallèle de l’amortisseur principal : linéaire, quadratique, cubique, quartique ou tabulé",
    ),
    (
        "compressibility of the oil column (with the expansion of the cylinder) before the valves",
        "compressibilité de la colonne d’huile (avec la dilatation du cylindre) avant les clapets",
    ),
    (
        "air in the oil: the oil column is soft while the force is small",
        "air dans l’huile : la colonne d’huile est souple tant que l’effort est faible",
    ),
    (
        "cavitation: the hydraulic force of one stroke is capped, and a void remains to be closed",
        "cavitation : l’effort hydraulique d’une course est plafonné, et il reste un vide à refermer",
    ),
    (
        "damping that falls with the temperature of the oil, measured or by its own heat",
        "amortissement qui baisse avec la température de l’huile, mesurée ou par sa propre chaleur",
    ),
    (
        "damping that is weaker (bypass) or firmer over a part of the stroke",
        "amortissement plus faible (bypass) ou plus ferme sur une partie de la course",
    ),
    (
        "stop at the end of the compression stroke, rubber or hydraulic",
        "butée en fin de course de compression, en caoutchouc ou hydraulique",
    ),
    (
        "stop at the end of the rebound stroke, rubber or hydraulic",
        "butée en fin de course de détente, en caoutchouc ou hydraulique",
    ),
    (
        "free play in an eye or mount; needs series_compliance",
        "jeu dans un œil ou une fixation ; nécessite series_compliance",
    ),
    (
        "damping that is weaker in fast strokes than in slow ones of the same speed",
        "amortissement plus faible dans les courses rapides que dans les lentes à même vitesse",
    ),
    (
        "blow-off valve that opens late and closes late: more force while speed rises",
        "clapet de décharge qui s’ouvre et se ferme en retard : plus d’effort pendant que la vitesse croît",
    ),
    (
        "mass moved by the driven end, between load cell and damper, or by the piston",
        "masse mue par l’extrémité entraînée, entre capteur d’effort et amortisseur, ou par le piston",
    ),
    ("the force channel lags the motion channels (rig)", "la voie d’effort retarde sur les voies de mouvement (banc)"),
    ("the load cell does not read zero without load (rig)", "le capteur d’effort ne lit pas zéro sans charge (banc)"),
    ("the zero of the load cell moves with time (rig)", "le zéro du capteur d’effort dérive avec le temps (banc)"),
    // Forms of effects.
    ("full", "complète"),
    ("slips from the first", "glisse dès le début"),
    ("bends before it slips", "fléchit avant de glisser"),
    ("relaxes", "se relâche"),
    ("friction in the rubber", "frottement dans le caoutchouc"),
    ("relaxes over decades and meets a stop", "se relâche sur des décades et rencontre une butée"),
    ("friction in the rubber, and a stop", "frottement dans le caoutchouc, et une butée"),
    ("all of the force goes through it", "tout l’effort y passe"),
    ("relaxes, and all of the force goes through it", "se relâche, et tout l’effort y passe"),
    (
        "friction in the rubber, and all of the force goes through it",
        "frottement dans le caoutchouc, et tout l’effort y passe",
    ),
    ("rebound chamber", "chambre de détente"),
    ("both chambers", "les deux chambres"),
    ("one chamber softer than the other", "une chambre plus souple que l’autre"),
    ("compression capped, gas pushes on", "compression plafonnée, le gaz continue de pousser"),
    ("compression capped, dead return", "compression plafonnée, retour mort"),
    ("rebound capped, force stays", "détente plafonnée, l’effort reste"),
    ("rebound capped, dead return", "détente plafonnée, retour mort"),
    ("compression capped, gas expands in the void", "compression plafonnée, le gaz se détend dans le vide"),
    ("foot valve does not refill", "le clapet de pied ne remplit pas"),
    ("measured temperature", "température mesurée"),
    ("oil warmer than measured", "huile plus chaude que mesurée"),
    ("heated by its own work", "chauffée par son propre travail"),
    ("isothermal", "isotherme"),
    ("takes time to cool", "met du temps à refroidir"),
    ("both strokes", "les deux courses"),
    ("groove", "rainure"),
    ("groove open in rebound", "rainure ouverte en détente"),
    ("groove open in compression", "rainure ouverte en compression"),
    ("bypass", "dérivation"),
    ("filter", "filtre"),
    ("stroke", "course"),
    ("a valve with play", "un clapet avec jeu"),
    ("a valve with mass", "un clapet avec masse"),
    ("opens and closes at different forces", "s’ouvre et se ferme à des efforts différents"),
    ("rubber", "caoutchouc"),
    ("hydraulic, gap", "hydraulique, fente"),
    ("hydraulic, orifice", "hydraulique, orifice calibré"),
    ("at the load cell", "au capteur d’effort"),
    ("inside, like oil in a long passage", "à l’intérieur, comme l’huile dans un long passage"),
    ("low-pass filter of the force channel", "filtre passe-bas de la voie d’effort"),
    ("zero set anew during the campaign", "zéro refait pendant la campagne"),
    ("settles as the rig warms up", "se stabilise quand le banc chauffe"),
];
