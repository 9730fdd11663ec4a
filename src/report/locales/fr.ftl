### Texts of the reports: French.

## The page.

decimal-sign = ,
note = Remarque.
all-tests-shown = tous les essais
previous = précédent
next = suivant
test-shown = Essai affiché
figure-help = Tracer un cadre dans une figure l’agrandit, un double clic la rétablit, le pointeur lit les valeurs.
zoom-reset = figure entière
save-table = enregistrer en CSV
save-about = Points-virgules entre les colonnes et virgules décimales : Excel ouvre ainsi le fichier en colonnes.
sort-help = Un clic sur un titre trie le tableau.
printed-brief = Sont imprimés le résultat et ce qui le fonde. Le fichier contient chaque essai et chaque tableau ; un rapport fait avec --full imprime tout.

## Figures.

measured = mesuré
model = modèle
fv-curve = courbe FV
noise-alone = bruit seul
axis-velocity = vitesse, mm/s
axis-displacement = déplacement, mm
axis-force = effort, N
axis-error = calculé − mesuré, N
axis-time = temps, s
axis-gap = vitesse croissante − décroissante, N
axis-error-percent = écart, %
axis-peak-velocity = vitesse de pointe, mm/s
axis-amplitude = amplitude, mm
plot-force-velocity = Effort selon la vitesse
plot-force-displacement = Effort selon le déplacement
plot-force-time = Effort selon le temps
plot-error-velocity = Écart selon la vitesse
plot-error-displacement = Écart selon le déplacement
plot-force-space = Effort selon la vitesse et le déplacement
plot-error-space = Écart selon la vitesse et le déplacement
plot-gap = Ouverture d’hystérésis selon la vitesse
plot-error-of-tests = Écart de chaque essai, % de son effort maximal
plot-error-map = Écart par amplitude et vitesse de pointe, %
plot-error-map-note = grand : { $model }, petit : { $curve } seule
plot-both-curves = Courbes FV des deux amortisseurs, avec frottement et effort de gaz
plot-peaks = Effort de pointe selon la vitesse de pointe
identified-curve = courbe identifiée avec frottement et gaz
measured-peaks = pointes mesurées
model-peaks = pointes du modèle
window = limites

## Validation: title and answer.

title-validation = Modèle d’amortisseur et mesures au banc
subtitle-validation = Modèle { $model } face aux mesures de { $data }
answer = Résultat
over-one-test = Sur le seul essai
over-tests = Sur { $tests } essais
headline = { $over }, le modèle s’écarte de l’effort mesuré de { $error } N en moyenne, soit { $percent } % de l’effort maximal d’un essai. La courbe effort-vitesse seule s’en écarte de { $curve_error } N, { $curve_percent } % : { $verdict }{ $closer }.
verdict-exact = le modèle suit exactement la mesure
verdict-smaller = l’écart moyen du modèle est plus petit d’un facteur { $ratio }
verdict-same = le modèle n’apporte rien de notable par rapport à la courbe
verdict-larger = l’écart moyen du modèle est plus grand d’un facteur { $ratio } : il fait moins bien que la courbe
closer-in = , et il est le plus proche des deux dans { $closer } essais sur { $tests }
left-out-figures = { $error } N ou { $percent } % (courbe seule { $curve_error } N ou { $curve_percent } %)
left-out-sentence = Sur les { $left } essais que l’identification n’a pas vus, l’écart moyen est de { $left_figures } ; sur les { $fitted } qui ont servi à l’ajuster, de { $fitted_figures }.
only-fitted = Tous les essais ont servi à identifier le modèle : ces chiffres montrent comment il s’ajuste, non comment il prédit.
largest-error = Le plus grand écart en pour cent est celui de l’essai « { $test } » : { $percent } %, soit { $error } N sur { $force } N.
noise-sentence = Le bruit de l’effort mesuré donnerait à lui seul un écart moyen d’environ { $noise } N ; aucun modèle ne peut faire mieux.

## Its sections.

fv-section = Courbe FV et pointes mesurées
fv-caption-by-setting = Chaque point est l’effort d’un essai à sa vitesse de pointe, moyenne de ses cycles, au réglage de l’essai.
fv-caption = Chaque point est l’effort d’un essai à sa vitesse de pointe, moyenne de ses cycles. La ligne est ce que donne le modèle à vitesse constante : courbe FV, frottement et effort du gaz. Où les points quittent la ligne, l’amortisseur dépend d’autre chose que de la vitesse.
worst-section = Essai le moins bon : { $test }
worst-caption = L’essai au plus grand écart en pour cent de son effort.
matrix-section = Écarts par amplitude et vitesse de pointe
key-section = Écarts en chiffres
tests-section = Écarts de chaque essai
single-section = Essais un par un
single-about = Triés par écart, le pire d’abord. Les boucles montrent les { $cycles } derniers cycles entiers d’un essai ; un essai sans cycle entier est montré en entier. Les écarts sont calculé moins mesuré. L’ouverture d’hystérésis est la moyenne de tous les cycles entiers.
single-most = Des { $tests } essais, les { $shown } aux plus grands écarts sont montrés.
hysteresis-section = Hystérésis
identification-section = Identification
parameters-section = Paramètres du modèle
parameters-range = Bas et haut sont les bornes de l’intervalle à 95 %.
made-section = Comment ce rapport a été fait

## Tables.

col-tests = essais
col-number = nombre
col-force-of = effort de
col-mean-error = écart moyen, N
col-error-percent = écart, %
col-region1 = zone 1, N
col-region2 = zone 2, N
col-rms = écart efficace, N
col-test = essai
col-amplitude = amplitude, mm
col-frequency = fréquence, Hz
col-peak-velocity = vitesse de pointe, mm/s
col-max-force = effort maximal, N
col-in-fit = ajusté
yes = oui
no = non
group-curve = courbe FV seule
all-tests = tous les essais
used-in-fit = ayant servi à l’ajustement
left-out-of-fit = laissés hors de l’ajustement
key-caption = Écart moyen : moyenne de |calculé − mesuré| sur les échantillons d’un essai. Écart en pour cent du plus grand effort mesuré de l’essai. Zones 1 et 2 : parts de l’écart moyen dues aux échantillons plus lents et plus rapides que { $boundary } mm/s ; leur somme est l’écart moyen. L’écart efficace (racine de la moyenne des carrés) pèse davantage les grands écarts. Tout est moyenne sur les essais, chacun de même poids.
row-rule = Chaque essai a le même poids dans sa ligne ; le pour cent est celui du plus grand effort de la ligne.
by-amplitude = Essais d’une même amplitude réunis. { $rule }
by-peak-velocity = Essais d’une même vitesse de pointe réunis. { $rule }
tests-caption = Chaque essai pour lui-même ; le pour cent est celui de son propre effort maximal.
row-amplitude = { $value } mm d’amplitude
row-peak-velocity = { $value } mm/s de vitesse de pointe
row-slow = essais lents de frottement, sous { $value } mm/s
row-not-periodic = essais sans cycle entier
col-cycles = cycles
group-gap = ouverture moyenne, N
group-gap-error = écart d’ouverture, N
group-area = aire de boucle ∮F dv, N·m/s
group-energy = énergie ∮F dx, J
col-measured = mesuré
col-curve = courbe
hysteresis-caption = Moyennes sur les cycles entiers. Ouverture : différence entre l’effort à vitesse croissante et à vitesse décroissante, à vitesse égale ; sa valeur absolue est moyennée sur les vitesses de l’essai. Écart d’ouverture : moyenne de |ouverture calculée − ouverture mesurée|. Une aire négative dit que l’effort retarde sur la vitesse (compressibilité du gaz et de l’huile), une aire positive qu’il avance (masse en mouvement).
col-name = nom
col-value = valeur
col-unit = unité
col-low = bas
col-high = haut
col-source = origine
parameter-at = à { $place }
col-note = remarque
not-identified = non identifiable avec ces mesures
not-identified-assumed = non identifié : supposé { $value }, { $source }
not-identified-off = non identifié : l’élément est désactivé ({ $why })
assumed-usual = ce que montrent les amortisseurs ({ $source })
assumed-dimensions = d’après les dimensions ({ $source })
assumed-default = la valeur par défaut du modèle
assumed-held = les mesures ne la déterminent pas ; elle se situe entre la valeur habituelle et le meilleur ajustement

## Single tests.

notes-of-test = Ce que la lecture et le nettoyage ont fait ou remarqué :
motion-periodic = { $amplitude } mm d’amplitude à { $frequency } Hz, vitesse de pointe { $velocity } mm/s, { $cycles } cycles entiers.
motion-other = Non périodique, vitesse de pointe { $velocity } mm/s.
temperature = Température { $first } °C au début, { $last } °C à la fin.
force-noise = Bruit de l’effort { $noise } N efficaces.
test-used = A servi à l’ajustement.
test-left-out = Laissé hors de l’ajustement.
test-sentence = Effort maximal { $force } N. Écart moyen du modèle { $error } N, { $percent } % ; de la courbe effort-vitesse seule { $curve_error } N, { $curve_percent } %.

## The literature.

family-section = Selon le réglage
family-between = Une famille qui n’a pas vu { $at } s’y écarte de { $error } N ({ $percent }), { $ratio } fois autant qu’un ajustement à { $at } seul.
family-between-worse = Entre ses réglages, le modèle est moins bon qu’à ceux-ci : une famille qui n’a pas vu { $at } s’y écarte de { $error } N ({ $percent }), { $ratio } fois autant qu’un ajustement à { $at } seul. Des mesures entre { $at } et ses voisins aideraient le plus.
family-about = L’amortisseur dépend d’un réglage. À chaque essai, c’est celui de l’essai ; entre ceux du fichier de modèle, il est interpolé.
family-interpolated = { $setting } (interpolé)
plot-family = Effort à vitesse constante, par réglage
family-caption = Une courbe par réglage du fichier de modèle, en tirets pour les réglages des essais entre eux. Les points sont les efforts mesurés à la vitesse maximale, de la couleur de leur réglage.
family-table = Moyennes sur les essais de chaque réglage. La courbe FV est ajustée aux essais de ce réglage.
family-clamped = { $setting } (borné)
family-errors-section = Écarts à chaque réglage
family-left-out-table = Écart moyen sur les cycles moyens des essais ajustés. La famille sans un réglage est réajustée à tous les autres et interpolée ; aux bouts de la grille il n’y en a pas.
family-own-fit = ajustement à lui seul
family-fit = famille
family-without = famille sans lui
col-ratio = rapport
family-loops-section = Boucles par réglage
family-loops-about = Un même mouvement à chaque réglage qui l’a : amplitude { $amplitude } mm, vitesse maximale { $velocity } mm/s.
family-worst-about = Ci-dessous, à chaque réglage, l’essai au plus grand écart en pour cent.
family-worst-caption = { $setting } : { $test }, écart moyen { $error } N, { $percent } %
plot-over-setting = Effort selon le réglage
over-setting-caption = Effort du modèle à vitesse constante. Une ligne plate ne dépend pas du réglage.
plot-ratio = Rapport du plus dur au plus doux
ratio-caption = Effort à { $hard } sur effort à { $soft }, frottement compris, sans la force de gaz, aux vitesses de crête des essais.
axis-speed = vitesse absolue, mm/s
axis-ratio = rapport, -
number-varies = (dépend du réglage ; barres : intervalles à 95 %, une valeur sans barre n’est pas identifiée)
number-shared = (commun à tous les réglages ; barres : intervalle à 95 %)
family-numbers-section = Valeurs selon le réglage
family-numbers-table = Ce qui dépend du réglage, avec les intervalles à 95 % laissés par un ajustement.
family-varies = dépend
family-effects = Ce que porte chaque effet à chaque réglage : ce que change son retrait, tout le reste gardé.
family-dependences = Ce qui dépend du réglage, avec la probabilité de cette dépendance.
responses-section = Réponse aux échelons du réglage
responses-about = Le long du mouvement de chaque essai, l’effort au réglage avant un échelon et celui au réglage d’après sont connus par le modèle. La réponse est la part du chemin entre les deux que l’effort a parcourue ; un échelon compte ainsi pendant un sinus comme à vitesse constante.
responses-table = Réponse moyenne à tous les échelons entre les deux mêmes réglages, mesurée et selon le modèle. Les temps comptent dès l’échelon ; ceux depuis 10 % excluent le temps mort.
col-step = échelon
col-steps = échelons
col-t63 = jusqu’à 63 %, ms
col-t90 = jusqu’à 90 %, ms
col-t63-from-10 = de 10 à 63 %, ms
col-t90-from-10 = de 10 à 90 %, ms
col-overshoot = dépassement, %
plot-step-up = Réponse à un échelon montant
plot-step-down = Réponse à un échelon descendant
axis-since-step = temps depuis l’échelon, ms
axis-way = part du chemin, -
actuator-table = Valeurs de l’actionneur, avec les intervalles à 95 % laissés par un ajustement.
actuator-parts = Ce que possède la valve, avec la probabilité correspondante.
col-has-it = présent
plot-hysteresis-setting = Hystérésis selon le réglage
hysteresis-setting-caption = Effort du modèle à { $velocity } mm/s pendant que le réglage monte et descend lentement. La valve a { $hysteresis } de retard à la montée et autant d’avance à la descente.
way-up = montée
way-down = descente
family-changing = variable
response-time-up = réponse à un échelon montant, jusqu’à 63 %, ms
response-time-down = réponse à un échelon descendant, jusqu’à 63 %, ms
rise-time-up = réponse à un échelon montant, de 10 à 90 %, ms
rise-time-down = réponse à un échelon descendant, de 10 à 90 %, ms
settings-section = Selon les réglages
settings-all = tous
settings-caption = Chaque effet de l’amortisseur aux réglages, chacun diagnostiqué à part : probabilité et effort à chacun. Un effet de tous les réglages figure une fois.
settings-changes = Ce qui a changé par rapport à la référence aux réglages, chacun comparé à part : valeur avant et après, probabilité et effort à chacun.
settings-answers = La réponse à chaque réglage. N efficaces sur les cycles moyens de ses essais : avant l’ajout d’un effet, après, et la part du bruit.
col-setting = réglage
against-section = Face à la littérature
against-about = Chaque modèle est identifié par moindres carrés, de plusieurs départs, sur les essais qui ont servi au modèle validé, puis interrogé sur les essais laissés de côté. Écart efficace et écart moyen sont des moyennes sur les essais.
against-caption = Écart en pour cent du plus grand effort mesuré de chaque essai.
col-model = modèle
col-meaning = ce que c’est

## Limits.

certificate-title = Certificat : l’amortisseur et ses limites
certificate-subtitle = Mesures de { $data }, limites de { $limits }
certificate-section = Limites
certificate-pass = CONFORME. L’amortisseur respecte toutes les limites ({ $count }).
certificate-fail = NON CONFORME. L’amortisseur ne respecte pas { $failed } limites sur { $count }.
certificate-fail-untested = NON CONFORME. { $failed } des { $tested } limites vérifiées ne sont pas respectées ; { $untested } autres n’ont pu être vérifiées avec ces mesures : { $why }.
certificate-untested = INCOMPLET. Les { $tested } limites vérifiées sont respectées ; { $untested } autres n’ont pu être vérifiées avec ces mesures : { $why }.
certificate-nothing-tested = INCOMPLET. Aucune des { $count } limites n’a pu être vérifiée avec ces mesures : { $why }.
certificate-why-untested = il n’y a pas d’essai à cette vitesse, ou aucun assez lent pour le frottement et l’effort du gaz
certificate-why-untested-at-setting = il n’y a pas d’essai à cette vitesse et à ce réglage, aucun assez lent pour le frottement et l’effort du gaz, ou pas de tel saut du réglage
certificate-interpolated = { $tests }, interpolé
certificate-model-passes = Le modèle donne la même réponse à chaque limite.
certificate-model-fails = Le modèle répond autrement que la mesure à { $count } des limites : une simulation y montre un autre amortisseur.
certificate-caption = Les efforts sont ceux à la vitesse de pointe, moyenne des cycles de l’essai de plus longue course qui atteint la vitesse ; interpolés linéairement entre deux essais dont les vitesses diffèrent au plus d’un facteur { $ratio }, sinon ceux d’un essai à { $percent } % près de la vitesse. Détente et traction sont positives, compression négative. Effort du gaz et frottement sont moyenne et demi-différence des courses des essais lents. L’hystérésis est l’ouverture moyenne entre vitesse croissante et décroissante à vitesse égale.
subject-part = Pièce : { $text }
subject-serial = Numéro de série : { $text }
subject-tester = Essayé par : { $text }
subject-rig = Banc : { $text }
subject-measured = Mesuré le : { $text }
subject-temperature = Température pendant la mesure : { $low } à { $high } °C
to-fill-in = ______________________________
col-limit = limite
col-at = à, mm/s
col-low-limit = bas
col-high-limit = haut
col-verdict = verdict
col-from = essai
pass = conforme
fail = NON CONFORME
not-tested = NON VÉRIFIÉ
force-rebound = effort, détente
force-compression = effort, compression
gas-force = effort du gaz
friction = frottement
hysteresis = hystérésis

## How it was made.

made-version = Écrit par dashpot { $version }.
made-date = Date : { $date }.
made-command = Commande : { $command }
made-again = La même version, la même commande et les mêmes fichiers redonnent les mêmes chiffres. L’empreinte est SHA-256, telle que sha256sum l’affiche.
col-file = fichier
col-bytes = octets
made-all = Les { $count } fichiers ensemble : SHA-256 { $hash } (des lignes que sha256sum en affiche, dans cet ordre).
made-files = Fichiers lus.

## Manoeuvres.

manoeuvre-title = Manœuvre { $name }
manoeuvre-subtitle = Modèle { $model } face à sa courbe FV, pas de { $step } s
manoeuvre-answer = Avec le modèle, le plus grand effort d’amortisseur est de { $force } N, avec sa courbe FV seule de { $curve } N, tous deux en { $corner } ; les efforts y diffèrent de { $difference } N efficaces, { $share } % de l’effort efficace.
manoeuvre-answer-same = Le modèle et sa courbe FV donnent les mêmes efforts dans cette manœuvre.
manoeuvre-beyond = L’amortisseur { $corner } se meut à { $saw } mm/s ; sa courbe FV a été identifiée à { $ends } mm/s et continue tout droit au-delà, { $share } % du temps.
manoeuvre-quiet = À des pas de { $host } ms l’échange de l’effort et du mouvement broute : il ajoute jusqu’à { $curve } N (efficaces) à l’effort avec la courbe FV et { $model } N à celui avec le modèle. Les écarts d’effort et de pompage sont donc ceux de pas de { $quiet } ms ; tout le reste est tel que l’hôte le calcule.
manoeuvre-chassis = Accélération de pompage de la caisse : maximum { $peak } m/s² (courbe FV { $peak_curve }), efficace { $rms } m/s² (courbe FV { $rms_curve }) ; le pompage diffère de { $heave } mm efficaces.
corner-section = Efforts d’amortisseur
corner-force-velocity = { $corner } : effort selon la vitesse
corner-force-time = { $corner } : effort selon le temps
corner-difference = { $corner } : modèle moins courbe FV
axis-difference = modèle − courbe FV, N
corners-table = Roues en chiffres
corners-caption = Mouvement et effort de chaque amortisseur. L1 est avant gauche, R2 arrière droite.
col-corner = roue
group-largest-force = effort maximal, N
group-energy-j = énergie, J
col-rms-difference = différence efficace, N
road-section = Route et vitesse
road-caption = La route sous les roues avant, à gauche et à droite. Le véhicule roule à { $speed } km/h.
plot-road = Route sous les roues avant
axis-road = hauteur de route, mm
chassis-section = Caisse
plot-heave = Pompage de la caisse
plot-heave-acceleration = Accélération de la caisse
plot-roll = Roulis
plot-lateral = Accélération latérale
axis-heave = pompage, mm
axis-heave-acceleration = accélération de pompage, m/s²
axis-roll = roulis, °
axis-lateral = accélération latérale, m/s²
region-section = Domaine de travail
region-with-tests = Où les amortisseurs ont travaillé, sur les boucles mesurées au banc. En dehors, le modèle n’est pas vérifié.
region-without-tests = Où les amortisseurs ont travaillé. Avec --tests, les boucles du banc sont tracées dessous.
plot-region = { $corner } : domaine de travail
in-vehicle = dans le véhicule
rig-tests = essais au banc
vehicle-section = Véhicule
vehicle-caption = Le véhicule simulé. Avec --vehicle car.toml, chacun de ces noms peut recevoir une autre valeur.
wheel-left = gauche
wheel-right = droite
coupling-unstable = c h / m atteint { $moving } sur la roue de { $mass } kg (c : pente de l’effort selon la vitesse, h : pas) : un simulateur qui échange effort et mouvement avec un pas de retard est instable au-dessus de 1, sans retard au-dessus de 2 ; un pas plus court y remédie.
coupling-chatter = c h / m (c : pente de l’effort selon la vitesse, h : pas) est au plus { $moving } sur la roue de { $mass } kg en mouvement, mais { $all } où le frottement s’inverse (sous { $slow } mm/s) : l’échange y broute dans l’effort de frottement ; un pas plus court ou un frottement moins raide y remédie.
col-near-tests = près du banc, % du temps
saw-displacement = déplacement, mm
saw-velocity = vitesse, mm/s

## The workbook.

workbook-contents = Sommaire
workbook-sheet = feuille
workbook-about = ce qu’elle montre

## What a fit found.

fit-title = Résultat de l’identification
fit-subtitle = Modèle { $model } à partir des données du banc dans { $data }
fit-answer = Ajusté à { $tests } essais, écart { $error }.
quality-sentence = { $grade } : le modèle s’écarte de l’effort mesuré de { $error } N en moyenne ({ $percent } % de l’effort maximal), { $beside } ; { $curve }.
quality-noise = Aussi bon que le bruit le permet
quality-good = Bon ajustement
quality-fair = Ajustement moyen
quality-poor = Mauvais ajustement
quality-beside-noise = { $ratio } fois le bruit des mesures ({ $noise } N)
quality-noise-unknown = le bruit de ces mesures n’est pas connu
quality-curve-worse = la courbe FV seule s’en écarte de { $error } N ({ $percent } %), { $ratio } fois autant
quality-curve-no-worse = la courbe FV seule n’est pas plus mauvaise, { $error } N ({ $percent } %)
fit-measured = Erreurs de la mesure
fit-tests = Essais ajustés
remarks = Remarques
col-why = pourquoi
col-interval = intervalle à 95 %

## Of figures and tables everywhere.

comma = ,{ " " }
sentence-end = { $sentence }.
semicolon = { " " };{ " " }
colon = { " " }:{ " " }

## The direction that the files count positive.

sign-given = Dans les fichiers, la { $direction } compte positivement, comme indiqué.
sign-found = Dans les fichiers, la { $direction } compte positivement (sûr à { $percent } %).
sign-found-by = Dans les fichiers, la { $direction } compte positivement (sûr à { $percent } %) : { $reasons }.
range = { $low } à { $high }
before = avant
after = après

## Figures before and after.

axis-residual = mesuré − calculé, N
axis-residual-rms = valeur efficace mesuré − calculé, N
axis-resistance = résistance mesurée − calculée, N
axis-since-reversal = temps depuis l’inversion, ms
axis-error-rms = écart, N efficaces
plot-error-rms = Écart de chaque essai, N efficaces
plot-left-velocity = Ce qui reste, selon la vitesse
plot-left-size = Grandeur de ce qui reste, selon la vitesse
plot-left-up = Moyenne de ce qui reste, en accélérant
plot-left-down = Moyenne de ce qui reste, en ralentissant
plot-left-reversal = Moyenne de ce qui reste, après une inversion
plot-left-map = Moyenne de ce qui reste, selon la vitesse et le déplacement
fitted-tests = essais ajustés
left-out = mis de côté
stretch = { $test } ({ $place } sur { $count })

## Diagnosis: title and answer.

diagnosis-title = Où modèle et mesures divergent, et ce qui manque
errors-caption = Chaque colonne est un essai : de combien l’effort calculé s’écarte de l’effort mesuré, avant (gris) et après (rouge). Un point rouge sur le trait signifie qu’il ne reste que du bruit. Aucun ajustement n’a vu les essais mis de côté : ce qui s’y referme est réel.
error-unseen = Sur les { $tests } essais qu’aucun ajustement n’a vus, l’écart passe de { $before } à { $after } N efficaces
error-fitted = Aucun essai n’a été mis de côté (trop peu, ou aucun désigné) : ces chiffres montrent comment le modèle s’ajuste, non comment il prédit ; l’écart passe de { $before } à { $after } N efficaces
gap-is-closed = { $error } ; { $gap } de l’écart entre modèle et bruit sont comblés, chaque essai compté en unités de son propre bruit.
nothing-stays = Le modèle reste tel quel ; seuls ses paramètres ont été réajustés.
changed-stays = Le modèle garde sa forme ; ses paramètres sont maintenant ceux de cet amortisseur.
nothing-added-rivals = Rien n’a été ajouté : choisir au hasard entre des noms qui expliquent aussi bien les mesures ne vaudrait rien. Les causes possibles sont plus bas, avec les essais qui trancheraient.
nothing-added-unknown = Rien n’a été ajouté : le désaccord est décrit plus bas sans nom. Sa forme selon la vitesse, le déplacement et le temps dit quoi chercher sur l’amortisseur ou sur le banc.
worse-tests = { $count } des { $all } essais mis de côté s’écartent plus qu’avant, par exemple { $test }.
row-before = avant (le modèle tel que fourni, réajusté)
col-fitted-rms = essais ajustés, N efficaces
col-their-noise = leur bruit, N efficaces
col-left-out-rms = essais mis de côté, N efficaces
mean-cycles-caption = Sur des cycles moyens, moins bruités que des cycles seuls. Écart en pour cent : moyenne de |calculé − mesuré| d’un essai rapportée à son plus grand effort, moyenne sur tous les essais.
whole-deviation = { $error } N en moyenne ({ $percent } %)
whole-records = Sur tous les échantillons de toutes les mesures, comme le fait dashpot validate : { $came } avec le modèle tel que fourni, { $refitted } réajusté, { $improved } amélioré. Les chiffres ci-dessus portent sur des cycles moyens, où le bruit s’annule en moyenne.

## The picture of a diagnosis.

name-and-sure = { $name } (sûr à { $sure })
picture-named = Il manque : { $names }
picture-nothing = Il ne manque rien
picture-cannot-tell = Il manque quelque chose, et ces mesures ne peuvent dire quoi
picture-unknown = Il manque quelque chose qu’aucun effet connu n’explique
picture-below = En haut : essai { $test }, { $kind }. En bas : tous les essais.
kind-left-out = mis de côté à chaque ajustement
kind-fitted = ajusté

## Where they disagree.

where-section = Où ils divergent
no-region = Aucune zone ne ressort du bruit.
left-map-caption = Effort mesuré moins effort calculé, moyenne de tous les essais, en tout point de vitesse et de déplacement qu’ils atteignent ; les deux cartes ont la même échelle de couleurs. Une bande le long de la vitesse nulle est un frottement, une pente selon le déplacement un ressort ou le gaz, des signes opposés à vitesse égale un retard. Les deux axes donnent plus de place près de zéro.
left-size-caption = Grandeur du reste à chaque vitesse. Où le rouge suit la ligne pâle, il ne reste que du bruit.
left-reversal-caption = Ce qui suit une inversion : sous zéro, l’effort de l’amortisseur s’établit plus tard que calculé (souplesse, jeu, préglissement, voie en retard) ; au-dessus de zéro, il résiste davantage (décollement).
speeding-up-caption = La même vitesse pendant que la course accélère …
slowing-down-caption = … et pendant qu’elle ralentit. Où les deux diffèrent, une hystérésis manque ou est trop grande.
all-there = tous ceux qui y passent
rebound = détente
compression = compression
speeding-up = en accélérant
slowing-down = en ralentissant
both = les deux
col-direction = sens
col-speed = allure
col-mean-n = moyenne, N
col-rms-n = efficace, N
col-noise-n = bruit, N
col-in-words = en mots
regions-caption = Effort mesuré moins effort calculé du modèle tel que fourni (réajusté), sur les essais ajustés : zones qui ressortent du bruit, d’abord celles de tous les essais, puis les pires.

## What is missing.

findings-section = Ce qui manque
suspects-section = Causes possibles
suspects-cannot-tell = L’un de ceux-ci manque, le plus probable d’abord.
suspects-beside = Ce qui peut manquer en plus, le plus probable d’abord ; rien n’est assez probable pour être ajouté.
suspects-nearest = Ce qui s’en approche le plus ; rien n’est assez probable pour être nommé.
rig-added = Le banc a ajouté à la mesure : { $all }. Cela n’est corrigé que dans cette comparaison et ne fait pas partie du modèle amélioré ; remettre le banc en ordre avant la prochaine campagne.
changed-section = Paramètres différents de ceux de l’amortisseur de référence
inventory-section = Inventaire
col-force-rms = effort, N efficaces
col-share-of-force = part de l’effort
col-status = état
status-kept = conservé
status-added = ajouté
status-replaced = remplacé
status-removed = retiré
replaces = à la place de { $effect }
or-instead = ou { $effect } à sa place ({ $probability })
inventory-caption = Tous les effets du modèle donné et du modèle le plus probable. La force d’un effet est ce que change son retrait, tout le reste étant conservé.
other-effects = autres effets
plot-inventory = Effort de chaque effet, N efficaces
axis-effect-force = effort, N efficaces
inventory-bands-caption = Valeur efficace sur les essais ajustés d’une plage, bout à bout. Des efforts en opposition se compensent en partie : une barre peut dépasser leur somme.
shifts-section = Paramètres du modèle qui ont bougé
finding-heading = { $place }. { $effect }{ $form } : sûr à { $sure }
finding-form = { " " }({ $form })
finding-gap = { " " }Sans lui, { $gap } de l’écart réapparaissent.
finding-of-rig = Il vient du banc, non de l’amortisseur : corrigé dans la comparaison, non mis dans le modèle.
finding-added = Il est ajouté au modèle amélioré.
finding-what = { $meaning }. { $added }{ $gap }
finding-why = Où : { $path } (famille : { $family }, sûr à { $family_sure }). Pourquoi : sans lui, { $share } du désaccord reviennent ; il laisse moins de reste dans { $tests } des essais.
rivals-caption = Ce qui a été essayé d’autre à sa place.
col-parameter = paramètre
col-judged = jugement
plausible = vraisemblable
not-plausible = hors de ce que montrent amortisseurs et bancs : à prendre avec prudence
col-effect = effet
col-confidence = confiance
col-explains = explique
col-reference = référence
col-this-damper = cet amortisseur
changed-caption = Les changements sont classés par l’effort qu’ils produisent dans les essais.
col-change = changement
shifts-caption = Sans l’effet, ces paramètres en avaient absorbé une partie. Sont montrés ceux qui ont bougé de plus de trois écarts-types.

## Loops.

loops-section = Boucles avant et après
more-loops-section = Boucles d’autres essais
loops-about = Les essais dont le désaccord avant est la plus grande part de leur effort. En bleu le cycle moyen mesuré, en gris le modèle réajusté à ces essais, en rouge le modèle amélioré ; la troisième figure agrandit ce qui reste de l’effort.
loop-heading = { $test }, { $kind }
loop-errors = Écart { $before } N efficaces avant, { $after } N après ; le bruit seul donne { $noise } N.{ $closed }
loop-closed = { " " }{ $gap } de l’écart sont comblés.

## Errors by amplitude and peak velocity, before and after.

map-before = Écart avant, % de l’effort maximal
map-after = Écart après, % de l’effort maximal
map-before-caption = Une case par amplitude et vitesse de pointe ; foncé signifie un grand écart.
map-after-caption = La même chose avec ce qui a été trouvé, dans les mêmes couleurs.
mean-cycles-rule = Chaque essai a le même poids dans sa ligne ; le pour cent est celui du plus grand effort de la ligne. Écarts de cycles moyens : le bruit est plus faible que dans dashpot validate, qui compare chaque échantillon.

## Everything that was tried.

tried-section = Tout ce qui a été essayé
tried-about = À chaque examen, chaque forme de chaque effet est ajoutée au modèle et tous les paramètres sont réajustés avec elle, de plusieurs départs. Ce qui a été nommé est dans ce modèle : ses lignes viennent d’abord et comparent le modèle avec et sans lui. Explique : part de la moyenne des carrés au-delà du bruit. Reste : moyenne sur les essais, en unités de ce que laissent le bruit et la forme des courbes. Log-chances : combien de fois les mesures sont plus probables avec elle, en logarithme naturel, chaque essai compté comme un échantillon indépendant, le prix des paramètres ajoutés déduit. Valeurs inhabituelles : ce que coûtent des valeurs que les amortisseurs ne montrent guère, dans la même unité. La probabilité est celle de l’effet, toutes formes confondues.
col-form = forme
col-probability = probabilité
col-error-left = reste
col-log-odds = log-chances
col-strange = valeurs inhabituelles
col-tests-better = essais meilleurs
look = Examen { $number }.

## What to measure next.

limits-section = Que mesurer ensuite
next-tests-section = Essais à faire ensuite
cannot-show-section = Ce que ces mesures ne peuvent montrer
all-would-show = Tout effet connu se serait montré dans ces mesures.
col-cannot-show = pourquoi, et ce qui le montrerait
cannot-show-caption = Ni trouvés ni exclus.
col-next-amplitude = amplitude, mm
col-next-frequency = fréquence, Hz
col-next-mean = position moyenne, mm
col-side-force = effort latéral, N
col-difference-rms = différence, N efficaces
col-what-to-do = que faire
next-tests-caption = Différence : de combien les prédictions des explications y diffèrent. Un essai tranche là où elle dépasse nettement le bruit.

## Parameters of the improved model.

source-refitted = réajusté
source-added = ajouté : { $effect }

## Many dampers.

groups-title = Ce qui a changé entre amortisseurs
groups-subtitle = Modèle { $model } face à chaque groupe ; référence : { $reference }
groups-section = Ce qui a changé dans quel groupe
groups-caption = Chaque groupe à côté de la référence. N efficaces sur les cycles moyens des essais, le modèle réajusté : avant d’ajouter un nom, après, et ce que donne le bruit seul.
group-against = { $group }, face à { $reference }
col-group = groupe
col-answer = résultat
col-named = nommé
col-before-n = avant, N
col-after-n = après, N
col-group-noise = bruit, N
no-change = aucun changement au-delà des intervalles
not-compared = non comparé : ces mesures ne le montrent pas
other-groups = autres groupes
plot-group-curves = Courbes FV de tous les groupes
group-curves-caption = Effort de chaque amortisseur à vitesse constante, frottement et gaz compris, aussi loin que vont ses essais ; en tirets : la référence.
numbers-section = Paramètres qui ont changé
numbers-caption = Paramètres du modèle qui, dans au moins un groupe, diffèrent de la référence de plus que ce que les deux laissent ouvert.
col-quantity = grandeur
measurement-section = La mesure elle-même
aside-section = Laissés de côté
aside = Essais qui n’appartiennent à aucun groupe : { $tests }.
without-test = Lignes de la liste des groupes qui ne correspondent à rien dans les données : { $tests }.

# Names of effects, elements and parameters are short, and without commas, since they stand in lists.

## Names. Effects and elements.

name-fv-curve = courbe FV
name-gas-preload = effort de gaz constant
name-gas-spring = ressort à gaz
name-coulomb-friction = frottement sec
name-stribeck-friction = frottement avec décollement
name-presliding-friction = frottement à préglissement
name-viscous-friction = frottement visqueux
name-side-force-friction = frottement dû à l’effort latéral
name-series-compliance = souplesse en série
name-bushing = articulation élastique
name-parallel-spring = ressort parallèle
name-oil-compressibility = compressibilité de l’huile
name-aeration = air dans l’huile
name-cavitation = cavitation
name-gas-warming = effort du gaz selon la température
name-temperature-fade = baisse avec la température
name-position-dependent-damping = amortissement dépendant de la position
name-bump-stop = butée de compression
name-rebound-stop = butée de détente
name-free-play = jeu
name-frequency-selective-damping = amortissement sélectif en fréquence
name-valve-hysteresis = hystérésis de clapet
name-moving-mass = masse mobile
name-lagged-polynomial = polynôme avec retard
name-integration = intégration
name-cylinder-expansion = dilatation du cylindre

## Names. Effects of the rig, and what looks like something that has no name.

name-channel-delay = retard de la voie d’effort
name-force-offset = erreur de zéro du capteur d’effort
name-force-drift = dérive du zéro du capteur d’effort
name-gain-drift = dérive du gain de la voie d’effort
name-load-dependent-friction = frottement croissant avec la charge
name-load-cell-hysteresis = hystérésis du capteur d’effort
name-resonance = résonance

## Names. Their numbers.

name-delay = retard
name-rig-mass = masse sur le capteur d’effort
name-offset = erreur de zéro
name-drift = dérive
name-whole-drift = dérive totale
name-share = part
name-share-across = part en quadrature
name-share-growth = croissance de la part
name-cooling-rate = vitesse de refroidissement

## Names. Parts of the FV curve that change as one.

name-rebound-curve = effort en détente
name-compression-curve = effort en compression
name-rebound-low-speed = effort en détente à basse vitesse
name-compression-low-speed = effort en compression à basse vitesse
name-rebound-high-speed = effort en détente à haute vitesse
name-compression-high-speed = effort en compression à haute vitesse

## Names. The FV curve.

name-fv-form = forme de la courbe FV
name-fv-interpolation = interpolation de la courbe FV
name-fv-velocity = vitesse de la courbe FV
name-fv-force = effort de la courbe FV
name-fv-rebound-c1 = première pente en détente
name-fv-rebound-c2 = deuxième pente en détente
name-fv-rebound-c3 = troisième pente en détente
name-fv-rebound-v1 = premier coude en détente
name-fv-rebound-v2 = second coude en détente
name-fv-compression-c1 = première pente en compression
name-fv-compression-c2 = deuxième pente en compression
name-fv-compression-v1 = coude en compression

## Names. In series.

name-series-stiffness = raideur en série
name-series-damping = amortissement en série
name-internal-mass = masse interne
name-series-load = charge du ressort en série
name-free-play-gap = grandeur du jeu
name-free-play-load = charge sur le jeu
name-free-play-force = souplesse du contact
name-bushing-hardening = durcissement du caoutchouc
name-bushing-loss-stiffness = raidissement dynamique du caoutchouc
name-bushing-loss-time = temps de relaxation du caoutchouc
name-bushing-slip = course de glissement du caoutchouc
name-bushing-stop = course du caoutchouc à la butée
name-bushing-stop-stiffness = raideur de la butée du caoutchouc
name-bushing-slow-stiffness = raidissement lent du caoutchouc
name-bushing-slow-time = temps de relaxation lente du caoutchouc

## Names. Oil.

name-oil-stiffness = raideur de la colonne d’huile
name-oil-shortening = raccourcissement de la colonne d’huile
name-oil-chambers = chambres souples
name-oil-compression = rapport des raideurs de l’huile
name-aeration-stroke = course absorbée par l’air
name-aeration-force = effort qui absorbe l’air
name-aeration-compression = rapport d’air en compression
name-cavitation-force = limite de cavitation
name-cavitation-side = course qui cavite
name-cavitation-return = effort au retour
name-cavitation-form = forme de la cavitation
name-cavitation-velocity = vitesse limite du clapet de pied
name-cavitation-unfilled = part non remplie
name-lost-stroke = course perdue
name-cavitation-onset = début de la cavitation
name-cavitation-expansion = expansion du vide

## Names. Over the stroke.

name-bypass-share = part manquante dans la zone
name-bypass-centre = milieu de la zone
name-bypass-half-width = demi-largeur de la zone
name-bypass-blend = transition de la zone
name-bypass-strokes = courses de la zone
name-bypass-form = forme de la zone
name-bypass-flow = débit de la rainure

## Names. Heat.

name-fade-source = origine de la température
name-fade-coefficient = baisse par kelvin
name-fade-reference = température de référence
name-heat-capacity = capacité thermique
name-heat-transfer = chaleur cédée par kelvin
name-fade-laminar-force = effort limite laminaire
name-fade-slackening = atténuation de la baisse

## Names. Valves.

name-fsd-form = forme de la dépendance en fréquence
name-fsd-share = perte en courses rapides
name-fsd-time = constante de temps en fréquence
name-fsd-velocity = vitesse de remplissage
name-fsd-flow = débit de dérivation
name-fsd-force = effort de remplissage
name-fsd-laminar-force = limite laminaire de la dérivation
name-valve-hysteresis-share = part de l’hystérésis de clapet
name-valve-opening-force = effort d’ouverture du clapet
name-valve-closing-ratio = rapport fermeture/ouverture
name-valve-time = temps du clapet
name-valve-width = plage d’ouverture du clapet
name-valve-form = forme de l’hystérésis de clapet
name-valve-play = jeu du clapet
name-valve-damping = taux d’amortissement du clapet

## Names. Springs.

name-spring-linear = raideur linéaire
name-spring-quadratic = raideur quadratique
name-spring-cubic = raideur cubique
name-spring-quartic = raideur du quatrième degré
name-spring-displacement = déplacement de la table du ressort
name-spring-force = effort de la table du ressort

## Names. Friction.

name-coulomb-force = effort de frottement
name-coulomb-steepness = raideur du frottement
name-stribeck-form = forme de Stribeck
name-stribeck-breakaway-force = effort de décollement
name-stribeck-coulomb-force = frottement après décollement
name-stribeck-breakaway-velocity = vitesse de décollement
name-stribeck-velocity = vitesse de Stribeck
name-stribeck-fall = exposant de la chute
name-stribeck-rise = hauteur de la pointe
name-stribeck-rise-power = exposant de la montée
name-viscous-coefficient = coefficient visqueux
name-side-force-coefficient = frottement par effort latéral
name-side-force-steepness = raideur du frottement latéral
name-presliding-force = effort de frottement à préglissement
name-presliding-length = course de préglissement
name-presliding-power = forme du préglissement
name-presliding-return = retour après inversion
name-presliding-creep = vitesse de fluage

## Names. Gas.

name-gas-force = effort de gaz
name-gas-warming-rate = hausse de l’effort de gaz par kelvin
name-gas-warming-reference = température de référence du gaz
name-gas-stiffness = raideur du gaz
name-gas-length = longueur de la colonne de gaz
name-gas-adiabatic-index = exposant adiabatique
name-gas-thermal-time = temps thermique du gaz

## Names. The model of the literature.

name-polynomial = coefficients du polynôme
name-lag-slow = retard à basse vitesse
name-lag-fast = retard à haute vitesse
name-lag-v1 = vitesse basse du retard
name-lag-v2 = vitesse haute du retard

## Names. Masses and stops.

name-moving-mass-time = retard de la masse mobile
name-moving-mass-place = place de la masse mobile
name-bump-stop-clearance = course jusqu’à la butée de compression
name-bump-stop-stiffness = raideur de la butée de compression
name-bump-stop-progression = progressivité de la butée de compression
name-bump-stop-loss = perte de la butée de compression
name-bump-stop-damping = amortissement de la butée de compression
name-bump-stop-flow = écoulement de la butée de compression
name-rebound-stop-clearance = course jusqu’à la butée de détente
name-rebound-stop-stiffness = raideur de la butée de détente
name-rebound-stop-progression = progressivité de la butée de détente
name-rebound-stop-loss = perte de la butée de détente
name-rebound-stop-damping = amortissement de la butée de détente
name-rebound-stop-flow = écoulement de la butée de détente

## Names. The step.

name-method = méthode d’intégration
name-substeps = sous-pas

## Choices of a parameter: they stand in a list of a narrow panel.

choice-automatic = automatique
choice-both = les deux
choice-bypass = dérivation
choice-cap = effort limité
choice-compression = compression
choice-cubic-each-side = cubique par côté
choice-driven-end = extrémité menée
choice-elastic = retour élastique
choice-euler = Euler
choice-factor = facteur
choice-filter = filtre
choice-foot-valve = clapet de pied
choice-fourth-order = quatrième ordre
choice-full = complète
choice-gap = jeu
choice-groove = rainure
choice-hydraulic = effort hydraulique
choice-inside = à l’intérieur
choice-linear = linéaire
choice-measured = mesurée
choice-monotone-cubic = cubique monotone
choice-opening = ouverture
choice-orifice = orifice
choice-piecewise = par morceaux
choice-play = frottement du tiroir
choice-rebound = détente
choice-second-order = deuxième ordre
choice-self-heating = échauffement propre
choice-simplified = simplifiée
choice-slips = glisse aussitôt
choice-spool = masse du tiroir
choice-stroke = à chaque course
choice-table = tableau
choice-third-order = troisième ordre
choice-three-stage = trois étages
choice-whole = effort total

## What elements and effects are. Names of forms such as `bypass` stand in model files and are not translated.

element-fv-curve = amortisseur de base : la courbe effort-vitesse (FV)
element-series-compliance = ressort et amortisseur en série avec la masse interne (souplesse du gaz, de l’huile et de l’articulation)
element-free-play = jeu dans un œillet ou une articulation ; demande series_compliance
element-bushing = caoutchouc en série avec l’amortisseur : le ressort en série durcit et perd de l’énergie ; demande series_compliance
element-oil-compressibility = compressibilité de la colonne d’huile (avec la dilatation du cylindre) devant les clapets
element-aeration = air dans l’huile : la colonne d’huile est souple tant que l’effort est petit
element-cavitation = cavitation : l’effort hydraulique d’une course est plafonné et un vide reste à refermer
element-position-dependent-damping = amortissement plus faible (dérivation) ou plus ferme sur une partie de la course
element-temperature-fade = amortissement qui baisse avec la température de l’huile, mesurée ou due à sa propre chaleur
element-frequency-selective-damping = amortissement plus faible dans les courses rapides que dans les lentes de même vitesse
element-valve-hysteresis = clapet de décharge qui s’ouvre tard et se ferme tard : plus d’effort quand la vitesse croît
element-parallel-spring = ressort en parallèle avec l’amortisseur de base : linéaire, quadratique, cubique, du quatrième degré ou en table
element-coulomb-friction = frottement sec de niveau constant, F_s tanh(K v)
element-stribeck-friction = frottement sec avec pointe de décollement
element-viscous-friction = frottement visqueux, F_v v|v|
element-side-force-friction = frottement sec proportionnel à l’effort latéral
element-gas-preload = effort du gaz constant
element-gas-warming = effort du gaz qui croît avec la température de l’amortisseur
element-lagged-polynomial = courbe FV polynomiale avec un retard du premier ordre dont la constante de temps varie avec la vitesse
element-presliding-friction = frottement qui se retourne sur un court trajet après chaque inversion (Dahl)
element-gas-spring = croissance de l’effort du gaz avec le déplacement de la tige, de lent à rapide
element-moving-mass = masse mue par l’extrémité entraînée, entre capteur d’effort et amortisseur, ou par le piston
element-bump-stop = butée en fin de compression, caoutchouc ou hydraulique
element-rebound-stop = butée en fin de détente, caoutchouc ou hydraulique
element-integration = réglages de l’intégration à pas fixe
element-channel-delay = la voie d’effort retarde sur les voies de mouvement (banc)
element-force-offset = le capteur d’effort n’indique pas zéro sans charge (banc)
element-force-drift = le zéro du capteur d’effort dérive avec le temps (banc)

## What parameters mean.

parameter-fv-form = courbe FV de la table, ou de pentes et de coudes
parameter-fv-interpolation = allure de la table FV entre ses points
parameter-fv-velocity = vitesses de la table FV, détente positive, croissantes
parameter-fv-force = efforts de la table FV, traction positive, non décroissants
parameter-fv-rebound-c1 = Cr1 : pente en détente sous le premier coude
parameter-fv-rebound-c2 = Cr2 : pente en détente entre les coudes
parameter-fv-rebound-c3 = Cr3 : pente en détente au-dessus du second coude
parameter-fv-rebound-v1 = premier coude en détente
parameter-fv-rebound-v2 = second coude en détente
parameter-fv-compression-c1 = Cc1 : pente en compression sous le coude
parameter-fv-compression-c2 = Cc2 : pente en compression au-dessus du coude
parameter-fv-compression-v1 = coude en compression, en valeur absolue de la vitesse
parameter-series-stiffness = raideur du ressort en série, k_s
parameter-series-damping = amortissement à côté du ressort en série, c_s
parameter-internal-mass = masse mobile de tige, huile et gaz, m
parameter-series-load = ce que porte le ressort en série : l’effort hydraulique et les ressorts sur la masse, ou aussi frottement et effort du gaz, comme un œillet ou une articulation
parameter-free-play-gap = course libre de contact à contact, 2 g
parameter-free-play-force = effort auquel le jeu est à moitié refermé, F_0 : souplesse du contact
parameter-free-play-load = effort au milieu du jeu, F_1 : poids sur l’œillet, effort du gaz qu’il porte, serrage
parameter-bushing-hardening = flexion à laquelle le ressort en série a doublé son effort, d_h
parameter-bushing-loss-stiffness = part de la raideur en série que le mouvement rapide ou petit ajoute, k_1/k_s
parameter-bushing-loss-time = temps dans lequel cette part cède, tau
parameter-bushing-slip = flexion dans laquelle cette part cède par frottement, d_f ; grande : par le temps seul
parameter-bushing-stop = flexion à laquelle le caoutchouc rencontre une butée, de chaque côté, L
parameter-bushing-stop-stiffness = part de la raideur en série que la butée ajoute, k_e/k_s ; 0 : pas de butée
parameter-bushing-slow-stiffness = part de la raideur en série qui cède lentement, k_2/k_s
parameter-bushing-slow-time = temps dans lequel cette part cède, tau_2
parameter-oil-stiffness = raideur de la colonne d’huile en x = 0, dilatation du cylindre comprise, k_o
parameter-oil-shortening = inverse de la longueur de la colonne en x = 0, lambda ; 0 : même raideur partout
parameter-oil-chambers = quelle colonne cède : celle de la chambre de détente, ou celle de la chambre sous pression
parameter-oil-compression = raideur de la colonne en compression, rapportée à celle en détente, r_o
parameter-aeration-stroke = course que l’air absorbe en détente, d_a
parameter-aeration-force = effort auquel la moitié de cette course est absorbée, F_a
parameter-aeration-compression = course que l’air absorbe en compression, rapportée à celle en détente, r_a
parameter-cavitation-force = plus grand effort hydraulique de cette course, C
parameter-cavitation-side = course dont l’effort est plafonné
parameter-cavitation-return = part du plafond qui demeure au retour pendant que le vide se referme : 1 le gaz continue de pousser, 0 course morte
parameter-cavitation-form = vide par l’effort limité de cette course, ou par un clapet de pied qui ne remplit pas la chambre derrière lui
parameter-cavitation-velocity = clapet de pied : vitesse de cette course au-delà de laquelle la chambre n’est plus remplie, v_f
parameter-cavitation-unfilled = clapet de pied : part du débit au-delà de cette vitesse qui manque, a
parameter-cavitation-onset = plafond : part de celui-ci à laquelle le vide s’ouvre, alpha ; 1 : au plafond même
parameter-cavitation-expansion = plafond : vide sur lequel la moitié du reste est gagnée pendant que son gaz se détend, e_1
parameter-bypass-share = part de l’effort FV qui manque dans la zone, a ; négative : une zone plus ferme
parameter-bypass-centre = déplacement au milieu de la zone, c
parameter-bypass-half-width = demi-longueur de la zone, w
parameter-bypass-blend = longueur sur laquelle la zone s’estompe, b
parameter-bypass-strokes = courses sur lesquelles elle agit
parameter-bypass-form = facteur sur l’effort FV, ou débit à côté des clapets
parameter-bypass-flow = rainure : vitesse de piston qui passe à côté pour un effort hydraulique de 1 kN dans la zone, q_b
parameter-fade-source = température donnée, ou celle de l’ambiance plus l’échauffement propre de l’amortisseur
parameter-fade-coefficient = baisse de l’amortissement par kelvin, alpha
parameter-fade-reference = température de la courbe FV, T_0
parameter-heat-capacity = capacité thermique de l’huile et du corps, C_h
parameter-heat-transfer = chaleur cédée à l’ambiance par kelvin, h
parameter-fade-laminar-force = effort auquel la moitié est encore laminaire et baisse, F_l ; grand : tout baisse
parameter-fade-slackening = à quelle allure la baisse par kelvin diminue, kappa ; 0 : exponentielle, 1/(T_0 + 95 degC) : loi de Vogel
parameter-fsd-form = part en retard, part qui revient dans chaque course, ou débit à côté des clapets qui cesse dans chaque course
parameter-fsd-share = part de l’effort que perdent les courses rapides, a
parameter-fsd-time = temps qui sépare le rapide du lent, tau
parameter-fsd-velocity = forme « stroke » : vitesse qui remplit la chambre de commande, u_0
parameter-fsd-flow = forme « bypass » : vitesse de piston qui passe à côté pour un effort hydraulique de 1 kN, q_s
parameter-fsd-force = forme « bypass » : effort hydraulique au-dessus duquel la chambre de commande se remplit à plein débit, F_0
parameter-fsd-laminar-force = forme « bypass » : effort hydraulique au-dessous duquel son écoulement est laminaire, F_l
parameter-valve-hysteresis-share = forme « opening » : part de l’effort que le retard ajoute, eta
parameter-valve-opening-force = effort auquel le clapet s’ouvre
parameter-valve-closing-ratio = forme « opening » : effort de fermeture sur effort d’ouverture ; 1 : le temps seul le retarde
parameter-valve-time = temps dans lequel il se meut, tau ; tiroir : période de son oscillation sur 2 pi
parameter-valve-width = effort sur lequel il s’ouvre, b
parameter-valve-form = une ouverture qui vient et part tard, ou un clapet en retard à toute ouverture par frottement ou par sa masse
parameter-valve-play = forme « play » : effort que le clapet ne suit pas, P
parameter-valve-damping = forme « spool » : taux d’amortissement, zeta
parameter-spring-linear = k_p de k_p x
parameter-spring-quadratic = k_p de k_p x|x|
parameter-spring-cubic = k_p de k_p x^3
parameter-spring-quartic = k_p de k_p x^3|x|
parameter-spring-displacement = déplacements du ressort en table, croissants ; vide : pas de table
parameter-spring-force = efforts du ressort en table, non décroissants
parameter-coulomb-force = niveau du frottement, F_s
parameter-coulomb-steepness = raideur du changement de signe, K
parameter-stribeck-form = laquelle des deux formes de Stribeck
parameter-stribeck-breakaway-force = effort de pointe (de transition), F_brk ou F_t
parameter-stribeck-coulomb-force = niveau après la pointe, F_c ou F_s
parameter-stribeck-breakaway-velocity = vitesse de la pointe, v_brk ou V_fs
parameter-stribeck-velocity = forme complète : échelle de vitesse de la chute, V_s
parameter-stribeck-fall = forme complète : exposant de la chute, a (1 Tustin, 2 Gauss)
parameter-stribeck-rise = forme complète : de combien la pointe approche F_t, c
parameter-stribeck-rise-power = forme complète : exposant de la montée, d
parameter-viscous-coefficient = F_v de F_v v|v|
parameter-side-force-coefficient = frottement par effort latéral, k_avg
parameter-side-force-steepness = raideur du changement de signe, K
parameter-gas-force = effort du gaz, positif s’il pousse la tige dehors
parameter-gas-warming-rate = accroissement de l’effort du gaz par kelvin, c
parameter-gas-warming-reference = température à laquelle l’effort du gaz est celui des autres éléments, T_0
parameter-polynomial = coefficients de v^0, v^1, ...
parameter-lag-slow = constante de temps à basse vitesse
parameter-lag-fast = constante de temps à haute vitesse
parameter-lag-v1 = vitesse à laquelle la constante de temps commence à changer
parameter-lag-v2 = vitesse à laquelle elle a changé
parameter-presliding-force = niveau du frottement après un long trajet, F_c
parameter-presliding-length = trajet dans lequel l’effort approche son niveau d’un facteur e, z_0
parameter-presliding-power = 1 : glisse dès le début (Dahl) ; plus : fléchit élastiquement avant de glisser, n
parameter-presliding-return = après une inversion un contact fléchi glisse aussitôt, ou revient d’abord élastiquement
parameter-presliding-creep = vitesse au-dessous de laquelle le contact flue, v_c
parameter-gas-stiffness = raideur lente (isotherme) en x = 0, k
parameter-gas-length = volume de gaz en x = 0 sur l’aire de la tige, L : à quelle allure il raidit
parameter-gas-adiabatic-index = rapport de la raideur rapide à la lente, gamma
parameter-gas-thermal-time = temps dans lequel le gaz prend la température de sa paroi, tau
parameter-moving-mass = masse, M
parameter-moving-mass-time = temps dont son effort retarde, tau ; court devant le mouvement
parameter-moving-mass-place = ce qui la meut : l’extrémité entraînée, ou le piston derrière la raideur en série
parameter-bump-stop-clearance = compression depuis x = 0 à laquelle la butée est rencontrée, en longueur positive
parameter-bump-stop-stiffness = raideur au premier contact
parameter-bump-stop-progression = profondeur à laquelle le ressort a deux fois l’effort d’un ressort linéaire
parameter-bump-stop-loss = part de l’effort du ressort perdue à l’aller et de nouveau au retour
parameter-bump-stop-damping = amortissement hydraulique à l’aller, à la profondeur de la progression
parameter-bump-stop-flow = effort hydraulique avec la vitesse, ou avec son carré (égaux à 1 m/s)
parameter-rebound-stop-clearance = détente depuis x = 0 à laquelle la butée est rencontrée
parameter-rebound-stop-stiffness = raideur au premier contact
parameter-rebound-stop-progression = profondeur à laquelle le ressort a deux fois l’effort d’un ressort linéaire
parameter-rebound-stop-loss = part de l’effort du ressort perdue à l’aller et de nouveau au retour
parameter-rebound-stop-damping = amortissement hydraulique à l’aller, à la profondeur de la progression
parameter-rebound-stop-flow = effort hydraulique avec la vitesse, ou avec son carré (égaux à 1 m/s)
parameter-method = méthode dans un pas ; automatic : la moins coûteuse qui garde l’erreur d’un pas de 1 ms sous un millième
parameter-substeps = sous-pas dans un pas de l’hôte ; 0 : autant que la raideur et l’amortissement du modèle en demandent
