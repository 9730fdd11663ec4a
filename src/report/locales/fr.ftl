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
over-tests = Sur { $tests ->
        [one] un essai
       *[other] { $tests } essais
    }
headline = { $over }, le modèle s’écarte de l’effort mesuré de { $error } N en moyenne, soit { $percent } % de l’effort maximal d’un essai. La courbe effort-vitesse seule s’en écarte de { $curve_error } N, { $curve_percent } % : { $verdict }{ $closer }.
verdict-exact = le modèle suit exactement la mesure
verdict-smaller = l’écart moyen du modèle est plus petit d’un facteur { $ratio }
verdict-same = le modèle n’apporte rien de notable par rapport à la courbe
verdict-larger = l’écart moyen du modèle est plus grand d’un facteur { $ratio } : il fait moins bien que la courbe
closer-in = , et il est le plus proche des deux dans { $closer ->
        [one] { $closer } essai
       *[other] { $closer } essais
    } sur { $tests }
left-out-figures = { $error } N ou { $percent } % (courbe seule { $curve_error } N ou { $curve_percent } %)
left-out-sentence = { $left ->
        [one] Sur l’essai que l’identification n’a pas vu
       *[other] Sur les { $left } essais que l’identification n’a pas vus
    }, l’écart moyen est de { $left_figures } ; sur les { $fitted } qui ont servi à l’ajuster, de { $fitted_figures }.
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
matrix-about = Une ligne est en pour cent de l’effort maximal de tous ses essais, y compris à un autre réglage. Une case est la moyenne de ses essais, chacun en pour cent de son propre effort maximal, comme dans la figure des essais. Une ligne avec des essais faibles peut donc être inférieure à ses cases.
key-section = Écarts en chiffres
tests-section = Écarts de chaque essai
single-section = Essais un par un
single-about = Triés par écart, le pire d’abord. Les boucles montrent { $cycles ->
        [one] le dernier cycle entier
       *[other] les { $cycles } derniers cycles entiers
    } d’un essai ; un essai sans cycle entier est montré en entier. Les écarts sont calculé moins mesuré. L’ouverture d’hystérésis est la moyenne de tous les cycles entiers.
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
motion-periodic = { $amplitude } mm d’amplitude à { $frequency } Hz, vitesse de pointe { $velocity } mm/s, { $cycles ->
        [one] { $cycles } cycle entier
       *[other] { $cycles } cycles entiers
    }.
motion-other = Non périodique, vitesse de pointe { $velocity } mm/s.
temperature = Température { $first } °C au début, { $last } °C à la fin.
force-noise = Bruit de l’effort { $noise } N efficaces.
test-used = A servi à l’ajustement.
test-left-out = Laissé hors de l’ajustement.
test-sentence = Effort maximal { $force } N. Écart moyen du modèle { $error } N, { $percent } % ; de la courbe effort-vitesse seule { $curve_error } N, { $curve_percent } %.

## The literature.

family-section = Selon le réglage
family-between = Laissé de côté pour l’essai, { $at } est prédit par une famille qui ne l’a pas vu avec une erreur de { $error } N ({ $percent } %), { $ratio } fois celle d’un ajustement à { $at } seul.
family-between-worse = Entre ses réglages, le modèle est incertain. Laissé de côté pour l’essai, { $at } est prédit par une famille qui ne l’a pas vu avec une erreur de { $error } N ({ $percent } %), { $ratio } fois celle d’un ajustement à { $at } seul. Le modèle lui-même contient { $at }. { $advice }
family-between-records = Des mesures entre { $at } et ses voisins aideraient le plus.
family-between-labels = Vérifier d’abord les réglages mis en doute des essais.
family-between-unknown = Aucun réglage n’a pu être laissé de côté : l’erreur entre les réglages est donc inconnue ; un troisième réglage la montrerait.
family-about = L’amortisseur dépend d’un réglage. À chaque essai, c’est celui de l’essai ; entre ceux du fichier de modèle, il est interpolé.
family-interpolated = { $setting } (interpolé)
plot-family = Effort à vitesse constante, par réglage
family-caption = Une courbe par réglage du fichier de modèle, en tirets pour les réglages des essais entre eux. Les points sont les efforts mesurés à la vitesse maximale, de la couleur de leur réglage.
family-table = Moyennes sur les essais de chaque réglage. La courbe FV est ajustée aux essais de ce réglage. Chaque essai est en pour cent de son propre effort maximal.
family-clamped = { $setting } (borné)
family-errors-section = Écarts à chaque réglage
family-left-out-table = Écart moyen sur les cycles moyens des essais ajustés. La famille sans un réglage est réajustée à tous les autres et interpolée ; aux bouts de la grille il n’y en a pas. Chaque essai est en pour cent de son propre effort maximal. Un ajustement à un seul réglage a moins de points de la courbe FV ; la famille peut donc être meilleure.
family-own-fit = ajustement à lui seul
family-fit = famille
family-without = famille sans lui
col-ratio = rapport
family-loops-section = Boucles par réglage
family-loops-about = Un même mouvement à chaque réglage qui l’a : amplitude { $amplitude } mm, vitesse maximale { $velocity } mm/s.
family-worst-about = Ci-dessous, à chaque réglage, l’essai au plus grand écart en pour cent.
family-worst-caption = { $setting } : { $test }, écart moyen { $error } N, { $percent } %
plot-surface = Effort selon la vitesse et le réglage
surface-caption = Effort du modèle à vitesse constante. Les lignes colorées sont les réglages du fichier de modèle, les lignes grises des vitesses constantes et des réglages intermédiaires. Les points sont les efforts mesurés à la vitesse maximale.
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
responses-late = Le modèle ne suit pas tous les échelons. Son effort atteint 63 % plus tard (+) ou plus tôt (−) que la mesure, de plus que l’incertitude de la mesure : { $steps }.
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
undecided = indécis
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
certificate-fail = NON CONFORME. L’amortisseur ne respecte pas { $failed ->
        [one] { $failed } limite
       *[other] { $failed } limites
    } sur { $count }.
certificate-fail-untested = NON CONFORME. { $failed ->
        [one] { $failed } limite
       *[other] { $failed } limites
    } sur { $tested } { $tested ->
        [one] vérifiée
       *[other] vérifiées
    } { $failed ->
        [one] n’est pas respectée
       *[other] ne sont pas respectées
    } ; { $untested ->
        [one] { $untested } autre n’a pu être vérifiée
       *[other] { $untested } autres n’ont pu être vérifiées
    } avec ces mesures : { $why }.
certificate-untested = INCOMPLET. { $tested ->
        [one] La limite vérifiée est respectée
       *[other] Les { $tested } limites vérifiées sont respectées
    } ; { $untested ->
        [one] { $untested } autre n’a pu être vérifiée
       *[other] { $untested } autres n’ont pu être vérifiées
    } avec ces mesures : { $why }.
certificate-nothing-tested = INCOMPLET. { $count ->
        [one] La limite n’a pas pu
       *[other] Aucune des { $count } limites n’a pu
    } être vérifiée avec ces mesures : { $why }.
certificate-why-untested = il n’y a pas d’essai à cette vitesse, ou aucun assez lent pour le frottement et l’effort du gaz
certificate-why-untested-at-setting = il n’y a pas d’essai à cette vitesse et à ce réglage, aucun assez lent pour le frottement et l’effort du gaz, ou pas de tel saut du réglage
certificate-unsure = { $verdict }, pas sûr : le temps mesuré est connu à ± { $value } ms près
certificate-damping = { $verdict } ; { $value } N en croissent avec la vitesse, c’est donc de l’amortissement
certificate-interpolated = { $tests }, interpolé
certificate-step = échelon de { $from } à { $to } : { $tests }
certificate-model-passes = Le modèle donne la même réponse à chaque limite.
certificate-model-fails = Le modèle répond autrement que la mesure à { $count ->
        [one] une
       *[other] { $count }
    } des limites : une simulation y montre un autre amortisseur.
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
made-all = { $count ->
        [one] Le fichier
       *[other] Les { $count } fichiers ensemble
    } : SHA-256 { $hash } (des lignes que sha256sum en affiche, dans cet ordre).
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
fit-answer = Ajusté à { $tests ->
        [one] un essai
       *[other] { $tests } essais
    }, écart { $error }.
quality-sentence = { $grade } : le modèle s’écarte de l’effort mesuré de { $error } N en moyenne ({ $percent } % de l’effort maximal), { $beside } ; { $curve }.
quality-noise = Aussi bon que le bruit le permet
quality-good = Bon ajustement
quality-fair = Ajustement moyen
quality-poor = Mauvais ajustement
quality-beside-noise = { $ratio } fois le bruit des mesures ({ $noise } N)
quality-beyond-noise = { $ratio } fois le bruit des mesures ({ $noise } N) : les essais montrent plus que le modèle ne contient
quality-noise-unknown = le bruit de ces mesures n’est pas connu
quality-curve-worse = la courbe FV seule s’en écarte de { $error } N ({ $percent } %), { $ratio } fois autant
quality-curve-no-worse = la courbe FV seule est à peu près aussi bonne ou meilleure, { $error } N ({ $percent } %)
quality-worst = En pour cent, le pire essai est { $test } : { $error } N en moyenne ({ $percent } % de l’effort maximal de cet essai ; la courbe FV seule { $curve } N).
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
error-unseen = { $tests ->
        [one] Sur l’essai qu’aucun ajustement n’a vu
       *[other] Sur les { $tests } essais qu’aucun ajustement n’a vus
    }, l’écart passe de { $before } à { $after } N efficaces
error-fitted = Aucun essai n’a été mis de côté (trop peu, ou aucun désigné) : ces chiffres montrent comment le modèle s’ajuste, non comment il prédit ; l’écart passe de { $before } à { $after } N efficaces
rating-left-out = { $grade } : sur les essais écartés, le modèle s’écarte de l’effort mesuré de { $error } N efficaces, { $ratio } fois leur bruit.
rating-fitted = { $grade } : sur les essais ajustés, le modèle s’écarte de l’effort mesuré de { $error } N efficaces, { $ratio } fois leur bruit.
gap-is-closed = { $error } ; { $gap } de l’écart entre modèle et bruit sont comblés, chaque essai compté en unités de son propre bruit.
gap-grows = { $error } ; l’écart entre modèle et bruit augmente de { $gap }, chaque essai compté en unités de son propre bruit.
nothing-stays = Le modèle reste tel quel ; seuls ses paramètres ont été réajustés.
changed-stays = Le modèle garde sa forme ; ses paramètres sont maintenant ceux de cet amortisseur.
nothing-added-rivals = Rien n’a été ajouté : choisir au hasard entre des noms qui expliquent aussi bien les mesures ne vaudrait rien. Les causes possibles sont plus bas, avec les essais qui trancheraient.
nothing-added-unknown = Rien n’a été ajouté : le désaccord est décrit plus bas sans nom. Sa forme selon la vitesse, le déplacement et le temps dit quoi chercher sur l’amortisseur ou sur le banc.
worse-tests = { $count ->
        [one] { $count } essai
       *[other] { $count } essais
    } sur { $all } mis de côté { $count ->
        [one] s’écarte
       *[other] s’écartent
    } plus qu’avant, par exemple { $test }.
row-before = avant (le modèle tel que fourni, réajusté)
col-fitted-rms = essais ajustés, N efficaces
col-their-noise = leur bruit, N efficaces
col-left-out-rms = essais mis de côté, N efficaces
mean-cycles-caption = Sur des cycles moyens, moins bruités que des cycles seuls. Écart en pour cent : moyenne de |calculé − mesuré| d’un essai rapportée à son plus grand effort, moyenne sur tous les essais.
whole-deviation = { $error } N en moyenne ({ $percent } %)
whole-records = Sur tous les échantillons de toutes les mesures, comme le fait dashpot validate : { $came } avec le modèle tel que fourni, { $refitted } réajusté, { $improved } amélioré. Les chiffres ci-dessus portent sur des cycles moyens, où le bruit s’annule en moyenne.
whole-records-refitted = Sur tous les échantillons de toutes les mesures, comme le fait dashpot validate : { $came } avec le modèle tel que fourni, { $refitted } réajusté. Les chiffres ci-dessus portent sur des cycles moyens, où le bruit s’annule en moyenne.
whole-records-other = Tel que fourni, le modèle s’écarte de ces mesures de { $came } ; réajusté, de { $refitted }. Il décrit donc un autre amortisseur, un autre réglage ou une autre température, et ses valeurs ont changé.

## The picture of a diagnosis.

name-and-sure = { $name } (sûr à { $sure })
picture-named = Cet amortisseur montre : { $names }
picture-nothing = Il ne manque aucun effet connu
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
status-added-unnamed = ajouté, non nommé
status-replaced = remplacé
status-removed = retiré
replaces = à la place ‹de›{ $effect }
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
finding-disagreement = { " " }Sans lui, { $gap } du désaccord reviennent.
finding-of-rig = Il vient du banc, non de l’amortisseur : corrigé dans la comparaison, non mis dans le modèle.
finding-added = Il est ajouté au modèle amélioré.
finding-what = { $meaning }. { $added }{ $gap }
finding-why = Où : { $path } (famille : { $family }, sûr à { $family_sure }). Avec lui, le résidu est plus petit dans { $tests } des essais.
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
loop-grown = { " " }L’écart augmente de { $gap }.

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
group-note = { $groups } : { $text }
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
numbers-caption = Paramètres du modèle qui, dans au moins un groupe, diffèrent de la référence de plus que ce que les deux laissent ouvert. En dessous, les nombres des effets nommés.
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
name-share = rapport
name-share-across = rapport en quadrature
name-share-growth = croissance du rapport
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
name-oil-chambers = chambres compressibles
name-oil-compression = rapport des raideurs de l’huile
name-aeration-stroke = course absorbée par l’air
name-aeration-force = effort qui absorbe l’air
name-aeration-compression = rapport d’air en compression
name-cavitation-force = limite de cavitation
name-cavitation-side = course qui cavite
name-cavitation-return = effort au retour
name-cavitation-form = forme de la cavitation
name-cavitation-velocity = vitesse limite du clapet de pied
name-cavitation-unfilled = fraction non remplie du débit
name-lost-stroke = course perdue
name-cavitation-onset = début de la cavitation
name-cavitation-expansion = expansion du vide

## Names. Over the stroke.

name-bypass-share = réduction d’effort dans la zone
name-bypass-centre = milieu de la zone
name-bypass-half-width = demi-largeur de la zone
name-bypass-blend = transition de la zone
name-bypass-strokes = courses de la zone
name-bypass-form = forme de la zone
name-bypass-flow = débit de la rainure

## Names. Heat.

name-fade-source = origine de la température
name-fade-coefficient = baisse de l’amortissement par kelvin
name-fade-reference = température de référence
name-heat-capacity = capacité thermique
name-heat-transfer = flux de chaleur par kelvin
name-fade-laminar-force = effort limite laminaire
name-fade-slackening = variation de la baisse en température

## Names. Valves.

name-fsd-form = forme de la dépendance en fréquence
name-fsd-share = perte d’effort à haute fréquence
name-fsd-time = constante de temps en fréquence
name-fsd-velocity = vitesse de remplissage
name-fsd-flow = débit de dérivation
name-fsd-force = effort de remplissage
name-fsd-laminar-force = limite laminaire de la dérivation
name-valve-hysteresis-share = effort ajouté par le retard du clapet
name-valve-opening-force = effort d’ouverture du clapet
name-valve-closing-ratio = rapport fermeture/ouverture
name-valve-time = constante de temps du clapet
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
name-stribeck-rise = raideur de la montée
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
choice-driven-end = extrémité mobile
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
element-series-compliance = ressort et amortisseur en série avec la masse interne : souplesse du gaz, de l’huile et des articulations
element-free-play = jeu dans un œillet ou une articulation ; demande series_compliance
element-bushing = articulation en caoutchouc en série avec l’amortisseur : ressort raidissant avec hystérésis ; demande series_compliance
element-oil-compressibility = compressibilité de la colonne d’huile en amont des clapets, dilatation du cylindre comprise
element-aeration = air libre dans l’huile : faible raideur de la colonne d’huile aux petits efforts
element-cavitation = cavitation : une course ouvre un vide que la course de retour doit refermer
element-position-dependent-damping = amortissement dépendant de la position : plus faible (dérivation) ou plus fort sur une partie de la course
element-temperature-fade = baisse de l’amortissement avec la température de l’huile, mesurée ou due à l’auto-échauffement
element-frequency-selective-damping = amortissement sélectif en fréquence : à vitesse égale, plus faible à haute qu’à basse fréquence de course
element-valve-hysteresis = clapet de décharge qui s’ouvre et se ferme avec retard : effort plus élevé quand la vitesse croît
element-parallel-spring = ressort en parallèle avec l’amortisseur de base : linéaire, quadratique, cubique, du quatrième degré ou en table
element-coulomb-friction = frottement de Coulomb : frottement sec de module constant, F_s tanh(K v)
element-stribeck-friction = frottement de Stribeck : frottement sec avec pointe de décollement
element-viscous-friction = frottement visqueux, quadratique en vitesse, F_v v|v|
element-side-force-friction = frottement sec proportionnel à l’effort latéral sur la tige
element-gas-preload = effort du gaz constant
element-gas-warming = effort du gaz qui augmente avec la température de l’amortisseur
element-lagged-polynomial = courbe FV polynomiale avec un retard du premier ordre, dont la constante de temps dépend de la vitesse
element-presliding-friction = frottement avec préglissement (Dahl) : il change de signe sur un court trajet après chaque inversion
element-gas-spring = variation de l’effort du gaz avec le déplacement de la tige, d’isotherme à adiabatique
element-moving-mass = inertie d’une masse entre capteur d’effort et amortisseur, entraînée par l’extrémité mobile, ou d’une masse entraînée par le piston
element-bump-stop = butée de compression en fin de course, caoutchouc ou hydraulique
element-rebound-stop = butée de détente en fin de course, caoutchouc ou hydraulique
element-integration = réglages de l’intégration à pas fixe
element-channel-delay = la voie d’effort retarde sur les voies de mouvement (banc)
element-force-offset = le capteur d’effort n’indique pas zéro sans charge (banc)
element-force-drift = le zéro du capteur d’effort dérive avec le temps (banc)

## What parameters mean.

parameter-fv-form = source de la courbe FV : table, ou coefficients d’amortissement et vitesses des coudes
parameter-fv-interpolation = interpolation entre les points de la table FV
parameter-fv-velocity = vitesses de la table FV, détente positive, croissantes
parameter-fv-force = efforts de la table FV, traction positive, non décroissants
parameter-fv-rebound-c1 = Cr1 : coefficient d’amortissement en détente sous le premier coude
parameter-fv-rebound-c2 = Cr2 : coefficient d’amortissement en détente entre les coudes
parameter-fv-rebound-c3 = Cr3 : coefficient d’amortissement en détente au-dessus du second coude
parameter-fv-rebound-v1 = vitesse au premier coude en détente
parameter-fv-rebound-v2 = vitesse au second coude en détente
parameter-fv-compression-c1 = Cc1 : coefficient d’amortissement en compression sous le coude
parameter-fv-compression-c2 = Cc2 : coefficient d’amortissement en compression au-dessus du coude
parameter-fv-compression-v1 = vitesse au coude en compression, en valeur absolue
parameter-series-stiffness = raideur du ressort en série, k_s
parameter-series-damping = coefficient d’amortissement en parallèle avec le ressort en série, c_s
parameter-internal-mass = masse mobile interne de la tige, de l’huile et du gaz, m
parameter-series-load = efforts que porte le ressort en série : effort hydraulique et ressort parallèle, ou aussi frottement et effort du gaz (œillet ou articulation)
parameter-free-play-gap = jeu total de contact à contact, 2 g
parameter-free-play-force = souplesse du contact : effort, au-delà de F_1, qui referme la moitié du jeu, F_0
parameter-free-play-load = charge au milieu du jeu, F_1 : poids sur l’œillet, effort du gaz, serrage
parameter-bushing-hardening = flexion à laquelle le raidissement double l’effort du ressort en série, d_h
parameter-bushing-loss-stiffness = raideur de la branche à relaxation rapide (Maxwell) sur la raideur en série, k_1/k_s
parameter-bushing-loss-time = temps de relaxation de la branche rapide, tau
parameter-bushing-slip = flexion sur laquelle le frottement des charges relaxe la branche rapide, d_f ; grande : relaxation dans le temps seul
parameter-bushing-stop = flexion à laquelle le caoutchouc rencontre une butée, dans chaque sens, L
parameter-bushing-stop-stiffness = raideur ajoutée par la butée, sur la raideur en série, k_e/k_s ; 0 : pas de butée
parameter-bushing-slow-stiffness = raideur de la branche à relaxation lente (Maxwell) sur la raideur en série, k_2/k_s ; 0 : pas de branche lente
parameter-bushing-slow-time = temps de relaxation de la branche lente, tau_2
parameter-oil-stiffness = raideur de la colonne d’huile en x = 0, dilatation du cylindre comprise, k_o
parameter-oil-shortening = inverse de la longueur de la colonne d’huile en x = 0, lambda ; 0 : raideur indépendante de la position
parameter-oil-chambers = chambre dont la colonne d’huile est compressible : toujours celle de détente, ou celle sous pression
parameter-oil-compression = rapport de la raideur de la colonne d’huile en compression à celle en détente, r_o
parameter-aeration-stroke = course que la compression de l’air absorbe en détente, d_a
parameter-aeration-force = effort auquel l’air a absorbé la moitié de sa course, F_a
parameter-aeration-compression = rapport de la course que l’air absorbe en compression à celle en détente, r_a
parameter-cavitation-force = plus grand effort hydraulique dans la course qui cavite, C
parameter-cavitation-side = course dans laquelle la cavitation se produit
parameter-cavitation-return = fraction de C qui agit au retour pendant que le vide se referme ; 1 : le gaz pousse encore, 0 : aucun effort
parameter-cavitation-form = cause du vide : effort limité dans la course qui cavite, ou clapet de pied qui ne remplit pas la chambre derrière le piston
parameter-cavitation-velocity = clapet de pied : vitesse dans la course qui cavite au-dessus de laquelle la chambre n’est plus remplie complètement, v_f
parameter-cavitation-unfilled = clapet de pied : fraction du débit au-dessus de v_f qui n’est pas remplie, a
parameter-cavitation-onset = plafond : effort auquel le vide s’ouvre, en fraction de C, alpha ; 1 : à C
parameter-cavitation-expansion = plafond : profondeur du vide à laquelle la détente du gaz a porté l’effort à mi-chemin de alpha C à C, e_1
parameter-bypass-share = fraction dont l’effort FV est réduit dans la zone, a ; négative : augmenté
parameter-bypass-centre = déplacement au centre de la zone, c
parameter-bypass-half-width = demi-longueur de la zone, w
parameter-bypass-blend = longueur de transition à chaque extrémité de la zone, b
parameter-bypass-strokes = courses sur lesquelles la zone agit
parameter-bypass-form = facteur sur l’effort FV, ou débit de dérivation en parallèle avec les clapets
parameter-bypass-flow = rainure : débit de dérivation dans la zone pour un effort hydraulique de 1 kN, en vitesse de piston, q_b
parameter-fade-source = température de l’huile : mesurée, ou ambiante plus auto-échauffement calculé
parameter-fade-coefficient = baisse relative de l’amortissement par kelvin, alpha
parameter-fade-reference = température de référence de la courbe FV, T_0
parameter-heat-capacity = capacité thermique de l’huile et du corps de l’amortisseur, C_h
parameter-heat-transfer = flux de chaleur vers l’ambiance par kelvin d’écart de température, h
parameter-fade-laminar-force = effort FV dont la moitié est laminaire et baisse, F_l ; grand : il baisse en entier
parameter-fade-slackening = variation de la baisse avec la température, kappa ; 0 : loi exponentielle, 1/(T_0 + 95 degC) : loi de Vogel
parameter-fsd-form = fraction de l’effort en retard, fraction qui s’établit dans chaque course, ou débit de dérivation qui cesse dans chaque course
parameter-fsd-share = fraction de l’effort perdue à haute fréquence, a
parameter-fsd-time = constante de temps du retard, ou du remplissage de la chambre de commande, tau
parameter-fsd-velocity = forme « stroke » : vitesse au-dessus de laquelle la chambre de commande se remplit à plein débit, u_0
parameter-fsd-flow = forme « bypass » : débit de dérivation pour un effort hydraulique de 1 kN, en vitesse de piston, q_s
parameter-fsd-force = forme « bypass » : effort hydraulique au-dessus duquel la chambre de commande se remplit à plein débit, F_0
parameter-fsd-laminar-force = forme « bypass » : effort hydraulique au-dessous duquel l’écoulement de dérivation est laminaire, F_l
parameter-valve-hysteresis-share = forme « opening » : plus grand effort que le retard ajoute, en fraction de l’effort FV, eta
parameter-valve-opening-force = effort auquel le clapet s’ouvre
parameter-valve-closing-ratio = forme « opening » : rapport de l’effort de fermeture à l’effort d’ouverture ; 1 : retard par la constante de temps seule
parameter-valve-time = constante de temps du mouvement du clapet, tau ; forme « spool » : période propre sur 2 pi
parameter-valve-width = plage d’effort sur laquelle le clapet s’ouvre, b
parameter-valve-form = une ouverture en retard, ou un clapet dont la position retarde à tout effort par frottement ou par sa masse
parameter-valve-play = forme « play » : variation d’effort qui ne déplace pas le clapet (frottement), P
parameter-valve-damping = forme « spool » : taux d’amortissement du clapet, zeta
parameter-spring-linear = raideur linéaire, k_p de k_p x
parameter-spring-quadratic = raideur quadratique, k_p de k_p x|x|
parameter-spring-cubic = raideur cubique, k_p de k_p x^3
parameter-spring-quartic = raideur du quatrième degré, k_p de k_p x^3|x|
parameter-spring-displacement = déplacements de la table du ressort, croissants ; vide : pas de table
parameter-spring-force = efforts de la table du ressort, non décroissants
parameter-coulomb-force = module de l’effort de frottement, F_s
parameter-coulomb-steepness = raideur du changement de signe à vitesse nulle, K
parameter-stribeck-form = forme de la courbe de Stribeck
parameter-stribeck-breakaway-force = effort de décollement (pointe), F_brk ou F_t
parameter-stribeck-coulomb-force = effort de frottement de Coulomb au-delà de la pointe, F_c ou F_s
parameter-stribeck-breakaway-velocity = vitesse à la pointe de décollement, v_brk ou V_fs
parameter-stribeck-velocity = forme complète : vitesse de Stribeck, échelle de la chute après la pointe, V_s
parameter-stribeck-fall = forme complète : exposant de la chute après la pointe, a (1 Tustin, 2 Gauss)
parameter-stribeck-rise = forme complète : raideur de la montée vers la pointe, c ; grande : la pointe atteint F_t
parameter-stribeck-rise-power = forme complète : exposant de la montée vers la pointe, d
parameter-viscous-coefficient = coefficient de frottement, F_v de F_v v|v|
parameter-side-force-coefficient = coefficient de frottement : effort de frottement sur effort latéral, k_avg
parameter-side-force-steepness = raideur du changement de signe à vitesse nulle, K
parameter-gas-force = effort du gaz, positif s’il pousse la tige dehors
parameter-gas-warming-rate = accroissement de l’effort du gaz par kelvin, c
parameter-gas-warming-reference = température à laquelle cet élément n’ajoute aucun effort de gaz, T_0
parameter-polynomial = coefficients de la courbe FV polynomiale, de v^0, v^1, ...
parameter-lag-slow = constante de temps du retard à basse vitesse
parameter-lag-fast = constante de temps du retard à haute vitesse
parameter-lag-v1 = vitesse au-dessous de laquelle la constante de temps est celle de basse vitesse
parameter-lag-v2 = vitesse au-dessus de laquelle la constante de temps est celle de haute vitesse
parameter-presliding-force = effort de frottement après un long trajet, F_c
parameter-presliding-length = déplacement de préglissement : trajet sur lequel l’écart à F_c diminue d’un facteur e, z_0
parameter-presliding-power = exposant du glissement, n ; 1 : glissement dès le début (Dahl), plus grand : déformation élastique avant le glissement
parameter-presliding-return = décharge après une inversion : avec glissement, ou élastique
parameter-presliding-creep = vitesse au-dessous de laquelle le contact flue, v_c
parameter-gas-stiffness = raideur isotherme du gaz en x = 0, k
parameter-gas-length = volume de gaz en x = 0 sur l’aire de la tige, L ; plus court : plus progressif
parameter-gas-adiabatic-index = exposant adiabatique : rapport de la raideur adiabatique à l’isotherme, gamma
parameter-gas-thermal-time = constante de temps thermique entre le gaz et la paroi, tau
parameter-moving-mass = masse mobile, M
parameter-moving-mass-time = retard de l’effort d’inertie, tau ; court devant le mouvement
parameter-moving-mass-place = point qui entraîne la masse : extrémité mobile de l’amortisseur, ou piston derrière la raideur en série
parameter-bump-stop-clearance = compression depuis x = 0 jusqu’au premier contact avec la butée, positive
parameter-bump-stop-stiffness = raideur de la butée au premier contact
parameter-bump-stop-progression = enfoncement de la butée auquel l’effort de ressort est le double de l’effort linéaire
parameter-bump-stop-loss = fraction de l’effort de ressort perdue en charge, et de nouveau en décharge
parameter-bump-stop-damping = coefficient d’amortissement hydraulique en charge, à l’enfoncement de la progression
parameter-bump-stop-flow = effort hydraulique proportionnel à la vitesse (fente) ou à son carré (orifice), égaux à 1 m/s
parameter-rebound-stop-clearance = détente depuis x = 0 jusqu’au premier contact avec la butée
parameter-rebound-stop-stiffness = raideur de la butée au premier contact
parameter-rebound-stop-progression = enfoncement de la butée auquel l’effort de ressort est le double de l’effort linéaire
parameter-rebound-stop-loss = fraction de l’effort de ressort perdue en charge, et de nouveau en décharge
parameter-rebound-stop-damping = coefficient d’amortissement hydraulique en charge, à l’enfoncement de la progression
parameter-rebound-stop-flow = effort hydraulique proportionnel à la vitesse (fente) ou à son carré (orifice), égaux à 1 m/s
parameter-method = méthode d’intégration dans un pas ; automatic : la moins coûteuse dont l’erreur reste sous un millième dans un pas de 1 ms
parameter-substeps = sous-pas dans un pas de l’hôte ; 0 : autant que la raideur et l’amortissement du modèle en exigent

# What reading says of records.

## What reading says of records. Lists.

records-comma = ,{ " " }
records-semicolon = { " " };{ " " }
records-quoted = « { $test } »
records-and-more = { $names } et { $count ->
        [one] { $count } autre
       *[other] { $count } autres
    }
records-or = { " " }ou{ " " }

## What reading says of records. Files and tables.

records-profile = lu selon { $file }
records-stray = dans { $folder }, non lus comme mesures : { $names }
records-below = les sous-dossiers de { $folder } contiennent { $count ->
        [one] { $count } fichier qui n’a pas été lu
       *[other] { $count } fichiers qui n’ont pas été lus
    } ({ $names }) ; si ce sont des essais du même amortisseur, --subfolders les lit aussi
records-columns-not-read = colonnes non lues : { $names }
records-by-unit = « { $column } » est lu comme { $channel } d’après sa seule unité ; si une autre colonne est visée, --column le dit
records-converted = converti en SI : { $channels }
records-from-unit = { $channel } depuis { $unit }
records-time-of-day = heure du jour comptée à partir de la première ligne
records-one-clock = les mesures sont mises sur une même horloge d’après la date et l’heure que portent leurs fichiers, de { $first } à { $last } : la chaleur et les dérives passent d’un fichier à l’autre
records-dates-assumed = dans la date { $date } (de { $at }), le jour ou le mois peut venir d’abord, et rien dans les fichiers n’en décide ; elle a été lue comme { $read }, { $why }. --dates day-first (jour d’abord) ou month-first (mois d’abord) le précise (dates dans campaign.toml)
records-dates-close = car les essais sont ainsi rapprochés
records-dates-american = le mois d’abord, comme entre barres obliques en Amérique
records-dates-usual = le jour d’abord, comme il est d’usage entre traits d’union
records-own-clocks = chaque mesure a sa propre horloge, si bien que la chaleur et les dérives ne passent pas d’un fichier à l’autre : { $why }
records-some-without-date = { $count ->
        [one] seul { $count } fichier
       *[other] seuls { $count } fichiers
    } sur { $all } { $count ->
        [one] porte
       *[other] portent
    } l’heure du début de l’essai
records-too-far-apart = d’après les heures que portent leurs fichiers, elles sont trop éloignées pour être une seule campagne
records-clocks-overlap = d’après les heures que portent leurs fichiers, elles se chevauchent ; ce sont peut-être les heures d’une exportation
records-two-rates = mesuré à une cadence plus élevée dans un groupe à part, et ramené par interpolation linéaire aux instants des voies plus lentes : { $names }
records-cut-off = l’écriture du fichier s’est interrompue, il manque donc des données à la fin ; { $rows ->
        [one] la ligne complète précédente a été lue
       *[other] les { $rows } lignes complètes précédentes ont été lues
    }. Refaire l’essai s’il devait être plus long
records-stale-rows = { $count ->
        [one] la première ligne (jusqu’à la ligne { $line }) appartient
       *[other] les { $count } premières lignes (jusqu’à la ligne { $line }) appartiennent
    } à un passage antérieur, car le temps revient ensuite de { $from } s à { $to } s ; { $count ->
        [one] écartée
       *[other] écartées
    }
records-crank = le temps est calculé d’après l’angle de la manivelle à { $rpm } tours par minute
records-resampled = mesuré à une autre cadence, et ramené par droites aux instants de force et de mouvement : { $names }
records-below-heading = la ligne { $line }, sous l’en-tête, ne contient pas de chiffres : { $text }
records-below-table = à partir de la ligne { $line }, sous le tableau, non lu : { $text }
records-between-rows = { $count ->
        [one] { $count } ligne entre les mesures ne contient pas de chiffres et a été ignorée
       *[other] { $count } lignes entre les mesures ne contiennent pas de chiffres et ont été ignorées
    } (ligne { $lines }), la première : { $text }
records-behind-rows = { $count ->
        [one] { $count } ligne contient
       *[other] { $count } lignes contiennent
    }, après les colonnes de l’en-tête, du texte qui n’a pas été lu (ligne { $lines }), le premier : { $text }
records-longer-rows = { $count ->
        [one] { $count } ligne contient
       *[other] { $count } lignes contiennent
    } plus de chiffres que l’en-tête n’a de colonnes, de sorte qu’on ne sait pas lequel va où ; { $count ->
        [one] cette ligne est omise
       *[other] ces lignes sont omises
    } (ligne { $lines }). En trop dans la première : { $text }

## What reading says of records. Gaps in time.

records-of-file = { $file } : { $text }
records-of-files = { $count ->
        [one] { $count } fichier
       *[other] { $count } fichiers
    } ({ $names }, ...) avec une remarque du même genre, la première : { $text }
records-gaps = trous dans le temps : { $places }{ $more }. Lu comme { $count ->
        [one] { $count } essai
       *[other] { $count } essais
    }{ $rest }
records-gap = { $seconds } s sans échantillons après { $from } s (ligne { $line })
records-more-gaps = { " " }et { $count ->
        [one] { $count } autre
       *[other] { $count } autres
    }
records-too-few-between = { " " }; { $count ->
        [one] { $count } échantillon entre des trous est
       *[other] { $count } échantillons entre des trous sont
    } trop peu pour un essai
records-stumps = { $count ->
        [one] { $count } morceau à côté d’un trou ne contient aucun cycle entier et a été écarté
       *[other] { $count } morceaux à côté d’un trou ne contiennent aucun cycle entier et ont été écartés
    } : { $places }
records-from-to = { $from } à { $to } s
records-at-speeds = { $count } essais à la suite, des courses à vitesse constante séparées là où la vitesse change ; l’horloge continue, la chaleur se transmet donc
records-speed-of-strokes = la vitesse est celle de chaque course entière, car une course a trop peu d’échantillons pour en tirer une évolution
records-at-settings = { $count } essais l’un après l’autre sans pause, séparés là où la course ou la fréquence change et se maintient ; l’horloge continue, pour que la chaleur se transmette
records-at-rests = { $count } essais l’un après l’autre, séparés aux repos entre eux d’après le mouvement avant et après ; le repos est coupé autour des cycles entiers, et l’horloge continue, de sorte que la chaleur se transmet

## What reading says of records. Rows.

records-overflows = { $count ->
        [one] { $count } valeur
       *[other] { $count } valeurs
    } de la voie { $channel } au-delà de ce que mesure un capteur, d’abord { $value } { $unit } à la ligne { $line } ; comptées comme manquantes
records-rows-dropped = { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } sur { $rows } { $count ->
        [one] écartée
       *[other] écartées
    } pour cellules vides ou sans nombre (ligne { $lines })
records-setting-held = { $count } des { $rows } valeurs du réglage « { $setting } » { $count ->
        [one] manque
       *[other] manquent
    } ; chacune est prise égale à la précédente
records-setting-start = le réglage « { $setting } » met { $seconds } s à atteindre sa valeur ; ce début a été coupé
records-setting-empty = la colonne du réglage « { $setting } » est vide : l’essai compte comme un essai sans lui, ou comme son nom le dit
records-unread-current = la colonne « { $column } » en { $unit } n’est pas lue ; si c’est le courant de la valve de l’amortisseur, donner --column current='{ $column }', sinon --ignore current
records-unread-setting = la colonne « { $column } » en { $unit } n’est pas lue ; si c’est le réglage de la valve de l’amortisseur, donner --column setting='{ $column }', sinon --ignore current
records-small-current = le courant est d’au plus { $current } mA et compte comme 0 A, car aucune valve n’y répond ; si la colonne est en A, donner --unit current=A
records-filled = { $count ->
        [one] { $count } valeur manquante
       *[other] { $count } valeurs manquantes
    } de la voie { $channel } { $count ->
        [one] complétée
       *[other] complétées
    } par des droites
records-empty-column = la colonne de la voie { $channel } est vide et a été écartée
records-repeated-rows = { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } en { $blocks ->
        [one] { $blocks } bloc
       *[other] { $blocks } blocs
    } { $count ->
        [one] répète une ligne précédente avec son horodatage
       *[other] répètent des lignes précédentes avec leurs horodatages
    }, d’abord à la ligne { $line } ; { $count ->
        [one] retirée
       *[other] retirées
    }
records-repeated-blocks = { $blocks ->
        [one] { $blocks } bloc
       *[other] { $blocks } blocs
    }, { $rows ->
        [one] { $rows } ligne
       *[other] { $rows } lignes
    } en tout, { $blocks ->
        [one] répète
       *[other] répètent
    } les lignes qui les précèdent sous de nouveaux horodatages (le premier : { $first ->
        [one] { $first } ligne
       *[other] { $first } lignes
    } à partir de la ligne { $line }) ; { $blocks ->
        [one] retiré
       *[other] retirés
    }, et le temps qui suit est recollé
records-out-of-order = le temps a reculé { $count } fois, d’abord à la ligne { $line } ; { $moved ->
        [one] { $moved } ligne remise
       *[other] { $moved } lignes remises
    } en ordre
records-shared-stamps = { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } sur { $rows } { $count ->
        [one] avait
       *[other] avaient
    } l’horodatage de la ligne précédente ; { $count ->
        [one] elle a été répartie
       *[other] elles ont été réparties
    } également jusqu’au suivant

## What reading says of records. Samples.

records-clipped-motion = la voie { $channel } est écrêtée à { $value } { $unit } sur { $percent } % des échantillons, d’abord à la ligne { $line } ; elle est écartée et tirée de la voie { $other }
records-rounded = { $channel } reste à { $value } { $unit } dans { $count ->
        [one] { $count } échantillon
       *[other] { $count } échantillons
    }, d’abord à la ligne { $line } ; d’autres essais vont plus loin, si bien que cela est pris pour un retournement et non pour la fin de la plage
records-clipped-force = l’effort est écrêté à { $value } N, d’abord à la ligne { $line } (échantillons : { $count }, { $percent } %) ; ces échantillons sont écartés
records-spiky = la voie { $channel } est hérissée de pics : { $percent } % des échantillons s’écartent de leurs voisins ; trop pour des pics isolés, laissés tels quels
records-spikes = pics de la voie { $channel } remplacés par des droites, le premier à la ligne { $line }, le plus grand écarté de { $largest } { $unit } (pics : { $spikes }, échantillons : { $count })

## What reading says of records. Motion.

records-consistent = la vitesse vaut { $gain } fois la dérivée du déplacement et { $lag } ({ $percent } % de la variance du déplacement inexpliqués)
records-no-lag = n’a pas de retard
records-lags = la suit de { $lag } ms
records-leads = la devance de { $lag } ms
records-differentiated = vitesse dérivée du déplacement par cubiques locales sur { $points } échantillons ({ $window } s), sans déphasage, −3 dB à { $frequency } Hz{ $shorter }
records-shorter = { " " }; sur moins là où le mouvement tourne dedans, { $percent } % des échantillons
records-integrated = déplacement intégré de la vitesse, à partir de { $start } mm ; décalage de vitesse de { $offset } mm/s retiré, soit une dérive de { $drift } mm sur la mesure ({ $basis })
records-not-periodic-ends = la mesure n’est pas périodique : l’amortisseur est supposé finir où il a commencé
records-cycles-return = d’après des cycles entiers, dans chacun desquels l’amortisseur revient

## What reading says of records. What the user knows of the sensors.

records-force-zero = zéro d’effort de { $force } N retranché, comme indiqué
records-gain = effort multiplié par { $gain }, comme indiqué
records-displacement-zero = zéro de déplacement de { $displacement } mm retranché, comme indiqué
records-force-turned = signe de l’effort inversé, comme demandé
records-motion-turned = signe du déplacement et de la vitesse inversé, comme demandé
records-gain-of = { $channel } multiplié par { $gain }
records-mass-taken-off = effort qui meut une masse de { $mass } kg sur le capteur retranché, comme indiqué
records-early-as-given = l’effort vient { $delay } ms avant le mouvement, comme indiqué ; le mouvement y a été déplacé, les échantillons d’effort sont tels qu’enregistrés
records-late-as-given = l’effort vient { $delay } ms après le mouvement, comme indiqué ; le mouvement y a été déplacé, les échantillons d’effort sont tels qu’enregistrés
records-taken-out = ce que l’identification a trouvé comme erreur de mesure a été retiré

## What reading says of records. Cycles.

records-no-cycles = aucun cycle entier trouvé ; la mesure est gardée entière ({ $samples ->
        [one] { $samples } échantillon
       *[other] { $samples } échantillons
    })
records-trimmed = coupé { $before } s ({ $samples_before ->
        [one] { $samples_before } échantillon
       *[other] { $samples_before } échantillons
    }) de repos et de lancement avant le premier cycle entier et { $after } s ({ $samples_after ->
        [one] { $samples_after } échantillon
       *[other] { $samples_after } échantillons
    }) après le dernier ({ $tail }) ; { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } à { $frequency } Hz { $cycles ->
        [one] gardé
       *[other] gardés
    }
records-unlike-cycles = en { $places } endroits entre les cycles, le mouvement n’est pas un cycle entier comme les autres (pause ou perturbation) ; gardé dans la mesure, exclu de ses cycles
records-noisy-last = le dernier cycle (à partir de { $start } s) s’écarte des autres de { $last } N efficaces, eux-mêmes de { $typical } N ; écarté
records-displacement-drifts = le déplacement moyen dérive de { $drift } mm sur { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } ({ $percent } % de la course) ; laissé tel quel
records-force-drifts = l’effort moyen dérive de { $drift } N sur { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } ({ $percent } % de son étendue) ; laissé tel quel

## What reading says of records. Figures that no damper has.

records-no-force = l’effort ne montre que du bruit dans { $tests } ; vérifier le capteur d’effort ou écarter ces essais
records-small-amplitude = la plus grande amplitude est de { $amplitude } { $unit } : l’unité du déplacement est-elle juste ?
records-slow = l’essai le plus rapide atteint { $velocity } { $unit } : les unités de temps et de mouvement sont-elles justes ? À partir d’essais lents seuls, un modèle n’apprend rien de la conduite
records-small-force = l’effort ne varie jamais de plus de { $force } N : son unité est-elle juste ?
records-torn = { $test } : contient moins d’un cycle et finit au milieu d’une course, à { $velocity } mm/s sur { $peak } mm/s au plus ; si le fichier est tronqué, l’exporter à nouveau, ou le laisser de côté par --exclude
records-twins = { $test } contient les mêmes échantillons que { $twin } et compte double

## What reading says of records. A force that comes late.

records-late = l’effort vient environ { $delay } ms après le mouvement : pris ainsi, une courbe selon la vitesse laisse { $left } % de sa variance inexpliqués, contre { $recorded } % tel qu’enregistré
records-late-not-moved = { $late }{ $energy }. L’hystérésis ressemble ici à un retard, donc rien n’a été déplacé. dashpot fit les distingue et signale le retard qu’il trouve ; le reste est l’hystérésis de l’amortisseur. Ne donner { $option } que si le banc retarde l’effort d’autant, de façon connue
records-would-feed = { " " }; tel qu’enregistré, l’amortisseur fournirait de l’énergie dans { $count ->
        [one] { $count } essai
       *[other] { $count } essais
    } sur { $all }

## What reading says of records. The direction that the files count positive.

records-standstill = l’effort à l’arrêt est de { $force } N ± { $error } N tel que comptent les fichiers ; le gaz pousse la tige dehors, ce qui { $verdict }
records-speaks-for-tension = indique que la traction est positive (détente)
records-speaks-for-push = indique que la poussée est positive (compression)
records-too-small-to-tell = est trop petit pour indiquer le sens
records-no-standstill = pas de points de retour à l’arrêt, l’effort du gaz ne peut donc être connu
records-asymmetry = du lent au rapide, l’effort croît { $ratio } fois autant à vitesse positive qu’à vitesse négative (connu à un facteur { $error } près) ; la plupart des amortisseurs résistent plus en détente, ce qui { $verdict }
records-speaks-for-rebound = indique que la détente est positive
records-speaks-for-compression = indique que la compression est positive
records-tells-nothing = ne dit rien
records-contradict = effort du gaz et asymétrie se contredisent ; le plus fort des deux a été suivi
records-not-dissipating = aucun essai ne dissipe nettement d’énergie : il n’est pas certain que l’effort et le mouvement aillent ensemble
records-maybe-exchanged = déplacement et force semblent échangés, de sorte que rien de cela n’est sûr
records-sign-unsure = que les fichiers comptent { $direction } positif n’est sûr qu’à { $percent } % : { $reasons }. Le préciser : { $option } si c’est juste, sinon l’autre sens
records-negative-gas = compté ainsi, le gaz tirerait la tige vers l’intérieur avec { $force } N, ce qu’aucun gaz ne fait : ou le sens est faux (--positive), ou le capteur d’effort a un zéro décalé (--force-zero)
records-sign-of-rig = { $file } : seule, la mesure serait comptée { $own } positif (sûr à { $percent } %) ; les mesures les plus sûres du banc disent { $other } positif ({ $sure } %), elle est donc comptée de même. Si elle vient d’un autre banc, indiquer --positive
records-signs-disagree = { $file } : compte { $own } positif (sûr à { $percent } %), les mesures auxquelles elle est comparée comptent { $other } positif ({ $sure } %) ; si elles viennent du même banc, l’une est fausse : indiquer --positive
records-weak = les indices sont faibles ; dire ce qu’il en est avec --positive rebound ou --positive compression
records-turned-round = retournés à la fois en mouvement et en force, { $tests } iraient avec les autres essais, tels que lus non : à vitesses pareilles, la force à mi-chemin entre détente et compression est de { $own } N dans { $test } et de { $usual } N dans les autres. Vérifier si ces fichiers comptent dans un autre sens, et corriger l’export ou les laisser de côté par --exclude
records-other-settings = { $first } a { $times } fois l’effort de { $second } dans le même mouvement : ce sont plusieurs amortisseurs, ou plusieurs réglages d’un seul (clics, courant), et un modèle ne peut pas les représenter tous. Les identifier séparément (dossiers, ou --exclude). { $belong }
records-several-settings = les essais ont été mesurés à { $count } réglages ({ $name }), et un modèle n’en contient qu’un : { $settings }. Les ajuster comme un seul amortisseur ({ $name }) avec dashpot fit --setting { $option }, ou chacun à part, les autres écartés avec --exclude ; dashpot diagnose --group les compare
records-not-one-damper = { $settings }. Pour les ajuster tous comme un seul amortisseur sans réglage, donner --setting { $none }
records-setting-at = { $value } : { $names }
records-setting-varies = à la valve de l’amortisseur, { $setting } varie entre { $low } et { $high } pendant tout l’essai
records-setting-changes = { $change }. dashpot fit --setting { $option } en identifie la réponse de la valve ; un modèle à un seul réglage ne peut pas le suivre (--exclude)
records-setting-steps = à la valve de l’amortisseur, { $setting } saute entre { $low } et { $high } pendant l’essai (sauts : { $count })
records-setting-name = le nom de { $test } indique { $named }, et sa voie { $setting } montre { $shown } : la voie compte (essais dont le nom et la voie se contredisent : { $count }). Vérifier lequel est juste ; pour prendre les noms, écrire leurs valeurs dans campaign.toml sous settings
records-setting-typed = { $text } n’est pas un réglage : indiquer un nombre de -{ $largest } à { $largest } avec son unité, par exemple 0,8 A, 12 clicks ou 3 bar
records-setting-quantity = { $text } n’est pas une valeur du réglage { $setting } que ces essais ont
records-setting-quantities = ces essais ont plusieurs réglages ({ $names }) ; corriger le réglage d’un essai là où seuls des essais d’un seul réglage sont ouverts
records-settings = D’après leurs efforts vont ensemble, du plus souple au plus dur : { $settings }{ $open }
records-setting = { $number }) { $names }
records-setting-all = tous ceux de '{ $name }' ({ $count })
records-setting-open = { " " }; pour { $names }, l’effort ne le dit pas
records-zero-off = la force de { $tests } s’écarte de { $low } à { $high } N de celle des autres essais à vitesses pareilles, autant dans les deux sens : le zéro du capteur de force s’est déplacé, le gaz était plus chaud, ou un amortisseur réglable avait un autre réglage. Régler le zéro avant chaque essai ; frottement et force de gaz en souffrent
records-given = { $direction } positive a été indiquée
records-against-given = { $direction } positive a été indiquée, mais les données indiquent l’inverse : { $reasons }

## What reading says of records. What a campaign does without.

records-left-out = écarté : { $fault }
records-no-record = écarté, n’étant pas une mesure : { $fault }
records-first-and-more = { $first } ; { $count ->
        [one] { $count } autre
       *[other] { $count } autres
    }
records-more-left-out = { $count ->
        [one] { $count } autre fichier ou essai a été écarté
       *[other] { $count } autres fichiers et essais ont été écartés
    }

## What reading says of records. Faults of files.

records-unknown-type = { $file } : n’est pas une mesure ; les mesures sont des fichiers { $kinds }
records-not-read = { $file } : est { $is }, ce qui n’est pas lu ; { $instead }
records-empty-file = { $file } : est vide (0 octet) ; l’exporter de nouveau
records-workbook = { $file } : ne peut être lu comme classeur ({ $cause }) ; l’enregistrer de nouveau en .xlsx, ou exporter la feuille en CSV
records-rpc = { $file } : ne peut être lu comme historique RPC III ({ $cause })
records-binary = { $file } : ne peut être lu comme { $kind } ({ $cause })
records-mat = { $file } : ne peut être lu comme fichier MAT ({ $cause }) ; l’enregistrer de nouveau avec save(..., '-v7')
records-no-header = { $at } : aucune ligne d’en-tête trouvée qui nomme le temps et d’autres voies ; la première ligne est « { $found } ».{ $near }
records-best-line = { " " }La mieux comprise est la ligne { $line }, avec { $known } ; un en-tête demande deux colonnes comprises.
records-angle-alone = { " " }La colonne « { $column } » est un angle de manivelle. Il donne le temps si une ligne au-dessus du tableau indique la vitesse, par exemple « Speed: 6 rpm ». Le déplacement n’en est pas calculé : exportez aussi le déplacement, dans une colonne à lui.
records-taken-for = « { $column } » pour { $channel }
records-figures-alone = { " " }Elle contient { $count ->
        [one] { $count } colonne
       *[other] { $count } colonnes
    } de chiffres sans en-têtes : dites en une fois laquelle est quoi, par leurs numéros, et dans quelles unités, par exemple { $options }.
records-no-data = { $at } : a un en-tête mais aucune ligne de données

## What reading says of records. What is wrong with what was asked for.

records-not-found = { $file } : il n’y a ni fichier ni dossier de ce nom ; vérifier le chemin
records-cannot-read = { $file } : ne peut être lu ({ $cause })
records-is-peak-table = { $file } : est un tableau de valeurs de crête et non une mesure en fonction du temps ; dashpot import peaks { $file } -o damper.toml en fait un modèle
records-not-regular = { $file } : n’est pas un fichier ordinaire mais un tube, un périphérique ou un dossier ; en enregistrer le contenu dans un fichier et le nommer
records-too-large = { $file } : compte { $size }, et les fichiers sont lus jusqu’à { $largest } ; le découper par essai, ou l’enregistrer avec moins de voies ou à une cadence plus faible
records-too-costly = { $at } : se décompresse au-delà de ce qu’un fichier de cette taille peut donner ; l’enregistrer de nouveau en CSV ou le découper par essai
records-too-many-columns = { $at }, ligne { $line } : a { $found } colonnes, plus que les { $most } qu’une mesure peut avoir ; n’enregistrer que celles qui sont nécessaires
records-empty-folder = { $folder } : ne contient aucune mesure ; un dossier de campagne contient { $kinds }
records-in-subfolders = { $folder } : ne contient lui-même aucune mesure ; { $count ->
        [one] { $count } fichier se trouve
       *[other] { $count } fichiers se trouvent
    } dans ses sous-dossiers : { $names }. Si ce sont des essais d’un même amortisseur, --subfolders les lit comme une campagne ; si chacun est un amortisseur à part, en nommer un, ou les comparer par dashpot diagnose --group folders
records-kinds = { $others } et { $last }
records-no-paths = aucune mesure donnée ; nommer un fichier de mesure ou un dossier de campagne
records-excludes-nothing = --exclude { $pattern } ne désigne aucun fichier ni essai ; le premier fichier s’appelle { $first }
records-excludes-all = --exclude ne laisse aucune mesure ; { $count ->
        [one] le seul fichier ou essai est désigné
       *[other] les { $count } fichiers et essais sont tous désignés
    }
records-profiles-disagree = { $first } et { $second } donnent des sens positifs différents ; les accorder, ou donner --positive
records-indispensable = { $channel } ne peut manquer aux mesures ; l’ôter de --ignore
records-in-line = { $at }, ligne { $line } : { $cause }

## What reading says of records. Headings and units.

records-understood = { $header } Sont compris : { $understood }. D’autres en-têtes se donnent par --column force="Load Cell 1"
records-swapped = { $at } : les en-têtes « { $first } » et « { $second } » semblent intervertis : { $evidence }. Corriger l’en-tête, ou donner --column { $of_first }="{ $second }" --column { $of_second }="{ $first }" (et --unit si l’unité l’est aussi) ; s’ils sont justes, insister par --unit { $of_first }=...
records-wrong-unit = { $evidence } ; cela indique des { $likely } écrits comme { $written }. Donner --unit { $channel }={ $likely }, ou insister par --unit { $channel }={ $written }
records-files-unit = { $count } des { $all } essais { $count ->
        [one] ne va pas
       *[other] ne vont pas
    } avec les autres, d’une manière qu’une unité explique : { $tests }. { $test } montre ±{ $force } N à { $velocity } mm/s, les autres ±{ $usual } N à { $there } mm/s ; cela indique des { $likely } écrits comme { $written }.{ $either }{ $labels } Corriger l’en-tête des fichiers fautifs, ou les mettre dans un dossier à eux, lancer une fois dashpot import-profile DOSSIER --unit { $channel }={ $first }, et nommer les deux dossiers. Ou les laisser de côté par --exclude ; ou insister par --unit { $channel }={ $written } que tous les fichiers sont en { $written }
records-or-the-others = { " " }Si ceux-ci sont justes, ce sont, à l’inverse, les autres qui sont faux : { $others }.
records-or-labels = { " " }Si les essais ont plusieurs réglages, des indications fausses peuvent avoir le même effet : les vérifier d’abord.
records-labels-deviate = les efforts de { $count } des { $all } essais contredisent ceux des autres essais à leur { $name } et s’accordent avec ceux d’un autre réglage : { $groups }. { $advice }
records-label-group = { $tests } (indication { $stated }, efforts de { $fitting })
records-label-group-or-unit = { $group }, ou { $likely } écrit { $written }
records-forces-unlike = les efforts de { $tests } s’écartent de ceux des autres essais à vitesse égale plus qu’un amortisseur ne les change ({ $test } : { $factor } fois ceux des autres essais) : vérifier l’unité, le gain et le réglage, ou exclure ces essais
records-labels-check = Vérifier les indications de ces essais ; une valeur corrigée se met dans campaign.toml sous settings
records-labels-mirrored = Chacun a l’effort de { $name } compté depuis l’autre bout. Vérifier de quel bout comptent ces essais et les autres ; les valeurs corrigées se mettent dans campaign.toml sous settings
records-missing-column = { $at }, ligne { $line } : aucune colonne pour { $missing } ; les colonnes sont { $found }.{ $near } Nommer la colonne par --column { $example }="en-tête"{ $otherwise }{ $units }
records-units-too = . Des unités manquent aussi : donnez-les telles que le fichier les a, par exemple { $options }
records-or-crank-speed = , ou indiquer la vitesse de la manivelle dans une ligne au-dessus du tableau, par exemple « Speed: 6 rpm » ; la colonne « { $column } » donne alors le temps
records-or-sample-rate = , ou, si le fichier n’en a pas, dire --sample-rate 1000 (échantillons par seconde)
records-several-columns = { $at }, ligne { $line } : plusieurs colonnes pourraient être { $channel } : { $names } ; en choisir une par --column { $channel }="{ $first }"
records-no-such-column = { $at }, ligne { $line } : il n’y a pas de colonne « { $wanted } » pour { $channel } ; les colonnes sont { $found }.{ $near }
records-no-setting-column = aucun essai n’a de colonne « { $wanted } » pour le réglage : vérifier l’en-tête, avec --column setting=HEADING ou dans campaign.toml
records-meant = { " " }S’agit-il de « { $near } » ?
records-missing-unit = { $at }, ligne { $line } : la colonne « { $column } » n’a pas d’unité ; l’écrire dans l’en-tête, « { $column } [{ $example }] », ou donner --unit { $channel }={ $example }. Compris pour { $channel } : { $understood }
records-missing-units = { $at }, ligne { $line } : aucune unité n’est donnée pour { $columns } ; dites-la telle que le fichier l’a, par exemple { $options }{ $in_heading }. Compris : { $understood }
records-or-in-heading = , ou écrivez-la dans chaque en-tête, par exemple « Force [N] »
records-unknown-unit = { $at }, ligne { $line } : la colonne « { $column } » a l’unité « { $unit } », qui n’est pas comprise pour { $channel } ; sont comprises { $understood }. Donner --unit { $channel }=... si l’en-tête est faux

## What reading says of records. What speaks for swapped headings.

records-time-stands = la colonne lue comme temps recule ou stagne dans { $percent } % des lignes, celle lue comme { $other } jamais
records-spans = le déplacement couvrirait { $displacement } mm et l’effort { $force } N
records-force-smoother = { $spans }, et l’effort serait le plus lisse des deux
records-derivative-of-force = la vitesse est la dérivée de la colonne lue comme effort (corrélation { $with_force }), non de celle lue comme déplacement ({ $with_displacement })
records-displacement-rougher = la colonne lue comme déplacement est { $times } fois plus rugueuse que celle lue comme effort, et l’amortisseur fournirait de l’énergie ; { $spans }

## What reading says of records. What speaks for another unit.

records-too-quick = { $record } ferait ±{ $amplitude } mm à { $frequency } Hz pendant { $seconds } s
records-too-long = { $count ->
        [one] le seul essai
       *[other] le plus rapide de { $count } essais
    } atteindrait { $velocity } mm/s, le plus long durerait { $hours } h, avec un échantillon toutes les { $step } s
records-too-stiff = aucun essai ne dépasserait ±{ $amplitude } mm, et { $force } N à { $velocity } mm/s feraient un amortissement de { $damping } N s/m
records-mixed-current = { $record } : le courant de la valve de l’amortisseur atteindrait { $current } A, et { $others } A au plus dans les autres essais ; cela parle pour des mA sous un en-tête en A. Corriger l’en-tête de ce fichier, ou l’écarter avec --exclude '{ $test }' ; donner --unit current=A pour insister
records-too-much-current = le courant de la valve de l’amortisseur atteindrait { $current } A
records-too-weak = { $count ->
        [one] le seul essai
       *[other] le plus fort de { $count } essais
    } montrerait ±{ $strongest } N, et { $test } ±{ $force } N à { $velocity } mm/s, soit un amortissement de { $damping } N s/m

## What reading says of records. What no damper has.

records-absurd = { $record } : montre { $what }, ce qu’aucun amortisseur de suspension n’a ; { $advice }
records-an-amplitude = une amplitude de { $amplitude } m
records-a-velocity = une vitesse de pointe de { $velocity } mm/s
records-a-force = un effort de { $force } N
records-say-mm = si le fichier est en mm, le dire : --unit displacement=mm, ou velocity=mm/s quand on intègre
records-check-motion-units = vérifier les unités de la vitesse et du temps : --unit velocity=mm/s, --unit time=s
records-no-more-force = un effort d’au plus { $force } N
records-say-stronger = si le fichier donne une autre unité, le préciser : --unit force=kN
records-unit-was-given = l’unité était indiquée, c’en est donc une autre, ou la colonne, le facteur ou le capteur est faux : les vérifier, et omettre --unit si l’en-tête porte l’unité
records-say-n = si le fichier est en N, le dire : --unit force=N

## What reading says of records. All tests of a campaign.

records-all-without-force = { $count ->
        [one] { $count } essai
       *[other] { $count } essais
    } sur { $all } { $count ->
        [one] ne montre
       *[other] ne montrent
    } aucun effort : dans { $record } il ne sort pas de son bruit de { $noise } N, bien que l’amortisseur bouge. Vérifier le capteur d’effort et sa voie (--column force="en-tête")
records-feeds-energy = l’amortisseur fournirait de l’énergie au banc, un signe est donc faux : { $cause }
records-few-feed = { $fewer ->
        [one] { $fewer } essai
       *[other] { $fewer } essais
    } sur { $count } { $fewer ->
        [one] fournit
       *[other] fournissent
    } de l’énergie, { $more ->
        [one] l’autre
       *[other] les { $more } autres
    } non : { $names }. { $apart }{ $also }
records-few-take = { $fewer ->
        [one] { $fewer } essai
       *[other] { $fewer } essais
    } sur { $count } { $fewer ->
        [one] dissipe
       *[other] dissipent
    } de l’énergie, { $more ->
        [one] l’autre
       *[other] les { $more } autres
    } non : { $names }. { $apart }{ $also }
records-apart = Ces fichiers comptent l’effort ou le mouvement dans un autre sens que les autres. Les charger à part, avec --flip force ou --flip motion pour ceux qui fournissent de l’énergie, ou corriger l’export
records-all-feed = dans { $count ->
        [one] le seul essai
       *[other] les { $count } essais
    } à boucle nette l’effort agit dans le sens du mouvement (corrélation { $correlation }), effort et mouvement sont donc comptés en sens opposés ; { $culprit }{ $also }
records-exchanged = déplacement et force semblent échangés dans { $count ->
        [one] { $count } essai
       *[other] { $count } essais
    } sur { $all } : { $names }. Dans { $test }, la colonne lue comme force suit un sinus, comme le fait un banc (ses harmoniques en font { $of_force } %), et celle lue comme déplacement non ({ $of_displacement } %)
records-exchanged-feed = { $exchanged } ; lu ainsi, l’amortisseur fournirait de l’énergie au banc. Donnez --column displacement="en-tête" et --column force="en-tête" dans l’autre sens, et --unit là où les unités suivent. Si seuls quelques fichiers sont concernés, placez-les dans un dossier à part, dites-le là avec dashpot import-profile, et nommez les deux dossiers
records-exchanged-doubt = { $exchanged }. Si c’est le cas, rien de ce qui suit n’est juste : donnez --column displacement="en-tête" et --column force="en-tête" dans l’autre sens, et retirez --flip
records-or-late = . Ou bien { $late } ; donner alors { $option }
records-flip-motion = { $standstill } ; déplacement et vitesse sont alors positifs en compression. Donner --flip motion (ou corriger l’export)
records-flip-force = { $standstill } ; déplacement et vitesse sont alors positifs en détente. Donner --flip force (ou corriger l’export)
records-flip-either = { $standstill }. Donner --flip force si les efforts de compression sont positifs, --flip motion si ce sont les mouvements (ou corriger l’export)

## What reading says of records. A motion to be imposed.

records-motion-beyond = { $at }, ligne { $line } : { $channel } vaut { $value }, or un mouvement reste dans ±{ $limit } ; vérifier l’unité de la colonne, que --unit indique
records-motion-gap = { $at }, ligne { $line } : { $channel } manque ou n’est pas un nombre ; un mouvement est pris tel quel, combler ou couper la lacune
records-motion-time = { $at }, ligne { $line } : le temps n’augmente pas : { $to } s vient après { $from } s ; un mouvement demande un temps croissant
records-short-motion = { $at } : a une ligne ; un mouvement en demande au moins deux
records-several-motions = { $file } : contient plusieurs essais, « { $first } » et « { $second } » ; un mouvement n’en est qu’un, couper le fichier

## What reading says of records. Faults of tests.

records-too-few = { $at } : n’a que { $samples ->
        [one] { $samples } échantillon utilisable
       *[other] { $samples } échantillons utilisables
    } ; un essai en demande au moins { $needed }, donc le mesurer de nouveau
records-missing = { $at }, ligne { $line } : la voie { $channel } manque ou n’est pas un nombre, ici et dans { $count ->
        [one] { $count } ligne
       *[other] { $count } lignes
    } sur { $rows } en tout ; trop pour les écarter. Réparer l’export{ $advice }
records-or-ignore = , ou écarter la voie avec --ignore { $channel }
records-time-backwards = { $at }, ligne { $line } : le temps recule de { $from } s à { $to } s. Si le fichier contient plusieurs essais à la suite, nommer « test » la colonne qui les distingue, ou le diviser ; sinon couper le bloc étranger
records-constant-time = { $at } : le temps n’avance pas, il vaut { $time } s à chaque ligne ; vérifier que la bonne colonne est lue comme temps
records-frozen = { $at }, lignes { $first } à { $last } : la voie { $channel } est figée à { $value } { $unit } pendant { $seconds } s alors que { $moving } ; { $advice }
records-clipped = { $at }, d’abord à la ligne { $line } : la voie { $channel } est écrêtée à { $value } { $unit } sur { $percent } % des échantillons, ce qui en laisse trop peu de fiables ; { $advice }
records-no-motion = { $at } : l’amortisseur ne bouge pas : la voie { $channel } ne montre que du bruit, dans { $range } { $unit }. Mesurer l’essai de nouveau ou, s’il doit rester à l’arrêt, le retirer
records-constant-force = { $at } : l’effort vaut { $value } N à chaque ligne alors que l’amortisseur bouge ; vérifier le capteur d’effort et son câble, et mesurer de nouveau
records-cell = { $at }, ligne { $line }, colonne « { $column } » : « { $text } » n’est pas un nombre{ $hint }
records-fields = { $at }, ligne { $line } : a { $found ->
        [one] { $found } champ
       *[other] { $found } champs
    } là où l’en-tête en a { $expected }{ $hint }
records-contradiction = { $at } : déplacement et vitesse se contredisent : { $cause }

## What reading says of records. What moves while a channel is frozen, and what to do.

records-damper-moves = l’amortisseur bouge
records-velocity-moves = la vitesse dit qu’il bouge
records-force-changes = l’effort change
records-displacement-changes = le déplacement change
records-check-cell = vérifier le capteur d’effort et son câble, et couper ces lignes ou mesurer de nouveau
records-read-displacement-only = couper ces lignes, ou ne lire que le déplacement : --ignore velocity
records-read-velocity-only = couper ces lignes, ou ne lire que la vitesse : --ignore displacement
records-cut-or-measure = couper ces lignes ou mesurer de nouveau

## What reading says of records. What to do about a clipped channel.

records-no-other-motion = il n’y a pas d’autre voie de mouvement ; mesurer de nouveau avec une plus grande étendue
records-larger-range = mesurer de nouveau avec une plus grande étendue du capteur d’effort ou de son amplificateur

## What reading says of records. Why a cell or a row may be wrong.

records-without-separators = { " " }; l’écrire sans séparateurs de milliers
records-format-as-numbers = { " " }; mettre les cellules au format nombre
records-quote-decimal-commas = { " " }; les virgules décimales demandent des guillemets autour des cellules, ou un point-virgule ou une tabulation entre les colonnes

## What reading says of records. How displacement and velocity contradict each other.

records-velocity-late = « { $column } » vient { $lag } ms { $side } la dérivée du déplacement, comme après un filtre ; la colonne n’a pas été utilisée, et la vitesse est tirée du déplacement
records-behind = après
records-ahead = avant
records-other-motion = l’intégrale de la vitesse n’explique que { $percent } % du déplacement ; ils n’appartiennent pas au même mouvement. Vérifier que les bonnes colonnes sont lues (--column velocity="heading"), { $advice }
records-opposite-signs = ils ont des signes opposés (la vitesse vaut { $gain } fois la dérivée du déplacement). Inverser l’un d’eux dans l’export, { $advice }
records-unit-slip = la vitesse vaut { $gain } fois la dérivée du déplacement : une erreur d’unité. Le plus probable : { $likely }{ $others }
records-unit-candidate = l’unité de la voie { $channel } est { $likely } là où { $read } a été lu, pour un essai de { $amplitude } mm à { $frequency } Hz et { $velocity } mm/s : donner { $option }
records-otherwise = . Sinon, { $others }
records-or-else = {" ; ou "}
records-other-scale = la vitesse vaut { $gain } fois la dérivée du déplacement. Vérifier les unités et l’étalonnage des deux, l’unité de temps, et si l’échantillonnage est assez rapide pour le mouvement, { $advice }
records-read-one-only = ou n’en lire qu’un : --ignore velocity (ou --ignore displacement)

## What reading says of records. Channels.

records-channel-time = temps
records-channel-displacement = déplacement
records-channel-velocity = vitesse
records-channel-force = effort
records-channel-side-force = effort latéral
records-channel-temperature = température
records-channel-current = courant
records-channel-setting = réglage

## What reading says of records. Files in formats that are not read, and what to do.

records-famos = un fichier imc FAMOS
records-old-workbook = un classeur d’Excel 97 à 2003 (.xls), ou un document de cette époque
records-open-document = un fichier OpenDocument
records-diadem-heading = l’en-tête d’un jeu de données DIAdem, dont les nombres sont dans d’autres fichiers
records-diadem = un jeu de données DIAdem
records-hdf5 = un fichier HDF5
records-database = une base de données
records-zip = une archive zip
records-gzip = un fichier compressé (gzip)
records-pdf = un PDF
records-xml = un fichier XML
records-catman = un fichier binaire de catman
records-export-from-imc = l’exporter d’imc FAMOS ou d’imc STUDIO en CSV, MDF 4 ou TDMS
records-save-as-xlsx = l’enregistrer en .xlsx
records-save-as-tdms = l’enregistrer dans DIAdem en TDMS
records-save-channels = enregistrer ses voies en CSV ou en fichier MAT
records-export-as-csv = exporter l’essai en CSV
records-unpack-folder = la décompresser et nommer le dossier
records-unpack = le décompresser
records-export-from-catman = l’exporter de catman en ASCII, MDF 4 ou MAT

# What a fit says.

## What a fit says. Lists.

identification-comma = ,{ " " }
identification-semicolon = { " " };{ " " }
identification-that = , que{ " " }

## What a fit says. Which tests a number was identified from.

identification-share-of = { $tests } { $percent } %
identification-no-test = aucun essai ne le montre

## What a fit says. The inventory.

identification-carries = { $effect } : { $force } N efficaces, { $share } de l’effort ; probabilité { $probability }
identification-carries-in-form = { $effect } ({ $form }) : { $force } N efficaces, { $share } de l’effort ; probabilité { $probability }

## What a fit says. What the data does not determine.

identification-not-identified = { $name } n’a pu être identifié de ces données ({ $why }) ; son élément est désactivé
identification-needs-side-forces = il faut des essais lents à deux efforts latéraux ou plus, avec une voie d’effort latéral
identification-taken-up = une courbe FV libre absorbe un terme en v²
identification-held = { $name } n’a pu être identifié de ces données ; sa valeur est tenue à { $value }
identification-at-bound = { $name } a atteint la borne de son domaine à { $value } : les données demandent ce que cet élément ne peut faire
identification-rare-value = { $name } vaut { $value }, hors de ce que montrent amortisseurs de cet effort et bancs ({ $low } à { $high }) : la valeur compense peut-être ce qui manque au modèle
identification-rare-assumed = { $name } est supposé à { $value }, hors de ce que montrent amortisseurs de cet effort et bancs ({ $low } à { $high }) : la valeur compense peut-être ce qui manque au modèle

## What a fit says. What was known of the damper beside its records.

identification-expected = { $name } était attendu à { $value } { $unit } (95 % : { $low } à { $high }) d’après les dimensions de l’amortisseur : { $facts }
identification-contradicts = { $name } contredit les dimensions de l’amortisseur : { $value } { $unit }, soit { $ratio } fois les { $expected } { $unit } que donnent { $facts }

## What a fit says. What the campaign cannot show.

identification-one-rate = tous les essais se retournent presque au même rythme, si bien qu’une voie d’effort en retard et un chemin série souple se ressemblent : la voie a été prise sans retard ; la même course au tiers de la fréquence les distinguerait
identification-one-test = dans un seul essai, une voie d’effort en retard et un chemin série souple se ressemblent : la voie a été prise sans retard ; la même course au tiers de la fréquence les distinguerait
identification-roads = { $roads ->
        [one] { $roads } long essai sans cycles est calculé
       *[other] { $roads } longs essais sans cycles sont calculés
    } en { $stretches ->
        [one] { $stretches } tronçon de { $seconds } s, choisi
       *[other] { $stretches } tronçons de { $seconds } s, choisis
    } pour parcourir tous les déplacements et toutes les vitesses ; les erreurs sur enregistrements entiers comptent chaque échantillon
identification-selected = la campagne compte { $all } essais, plus qu’une recherche n’en peut utiliser : { $selected } d’entre eux représentent l’ensemble, de chaque amplitude, vitesse, position moyenne, température et effort latéral, répartis sur toute sa durée. Les erreurs sur enregistrements entiers comptent tous les essais ; pour choisir soi-même, donner --exclude ou un dossier plus petit
identification-no-slow-test = il n’y a pas d’essai lent à cycles complets (pointe sous { $velocity } mm/s) : le frottement est tiré des parties lentes d’essais plus rapides
identification-no-slow-test-no-friction = il n’y a pas d’essai lent à cycles complets (pointe sous { $velocity } mm/s) : un tel essai montre le mieux le frottement, et le modèle n’en a pas
identification-one-amplitude = tous les essais ont presque la même amplitude : le ressort et la raideur série ne reposent que sur la fréquence
identification-one-amplitude-of-spring = tous les essais ont presque la même amplitude : le ressort ne repose que sur la fréquence
identification-one-amplitude-of-series = tous les essais ont presque la même amplitude : la raideur série ne repose que sur la fréquence
identification-one-fast-amplitude = tous les essais à plus de { $velocity } mm/s ont presque la même amplitude : la raideur série ne repose que sur la fréquence
identification-zero-moves = le modèle laisse de chaque essai un autre effort constant, de { $low } à { $high } N : le zéro de la voie d’effort bouge d’un essai à l’autre, ou le gaz s’échauffe. Faire le zéro avant chaque essai, ou mesurer sur une seule horloge, qui permet de trouver une dérive ; frottement et effort du gaz ne sont pas fiables

## What a fit says. What the measurement is off by.

identification-found-early = la voie d’effort est en avance de { $value } ms (95 % : { $low } à { $high })
identification-found-delay = la voie d’effort est en retard de { $value } ms sur le mouvement (95 % : { $low } à { $high })
identification-found-mass = le capteur d’effort entraîne une masse propre de { $value } kg (95 % : { $low } à { $high })
identification-found-gain-drift = le gain de la voie d’effort dérive de { $value } % par minute (95 % : { $low } à { $high })
identification-found-drift = le zéro de la voie d’effort dérive de { $value } N par minute (95 % : { $low } à { $high })
identification-or-warm-gas = aucune température n’a été enregistrée dans tous les essais : un gaz qui chauffe au fil de la campagne fait aussi baisser l’effort au repos. La température les distingue
identification-gas-at = gas_force vaut à { $temperature } °C, milieu des températures mesurées ; avec gas_warming_rate il croît avec elles
identification-doubtful-error = { $effect } n’a qu’une probabilité de { $probability } : un effet de l’amortisseur que l’ajustement n’essaie pas, comme de l’air dans l’huile, peut lui ressembler. dashpot diagnose essaie tous les effets
identification-taken-out-here = { $finding } : retiré ici, absent du modèle ; validate et diagnose le retirent aussi de ces mesures{ $option }
identification-give-option = { " " }; pour d’autres mesures de ce banc, donner { $option }, ou l’écrire dans leur campaign.toml
identification-taken-out-as-the-fit-did = retiré des mesures, comme l’a fait l’identification du modèle : { $findings }
identification-found-in-its-own = l’identification du modèle a trouvé dans ses propres mesures que { $findings } ; celles-ci en sont d’autres, et rien n’en a été retiré{ $option }
identification-if-the-same-rig = { " " }: si le même banc les a mesurées, donner { $options }

## What a fit says. What a model file holds that does nothing.

identification-idle = le fichier de modèle donne { $names }, mais l’élément { $element } est désactivé, et cela reste sans effet ; pour s’en servir, l’ajouter à elements

## What a fit says. Numbers that a model file does not give, and numbers that are not those of its fit.

identification-family-worse = la famille s’écarte { $ratio } fois autant qu’une identification de ce seul réglage : une valeur commune à tous peut être différente ici, certains de ces essais portent peut-être l’indication d’un autre réglage, ou ils sont trop peu nombreux pour montrer une différence
identification-alone-worse = un ajustement de ce réglage seul s’écarte { $ratio } fois autant que la famille, sa recherche a donc fini à une structure moins bonne : le rapport à lui ne dit rien
identification-on-defaults = l’élément { $element } est actif, mais le fichier de modèle ne donne pas { $names } : les valeurs par défaut de docs/parameters.md s’appliquent
identification-edited = { $names } : hors de l’intervalle à 95 % laissé par l’identification dans le fichier de modèle, donc modifié depuis ; ce que l’identification en savait est omis

## What a fit says. How far a fit is.

identification-preparing = préparation des mesures
identification-plain-curve = courbe FV simple
identification-first-fit = premier ajustement depuis plusieurs départs
identification-choosing-structure = comparaison du frottement, des ressorts, du chemin en série et des erreurs de mesure
identification-refining = affinage de l’ensemble
identification-piecewise = courbe linéaire par morceaux
identification-with-lag = polynôme avec retard
identification-done = terminé

## What a fit says. A damper over a setting.

identification-family-each = chaque réglage à part
identification-family-joint = tous les réglages ensemble : ce qui leur est commun et ce qui en dépend
identification-family-left-out = chaque réglage prédit par les autres
identification-family-actuator = réponse de la valve d’après les essais à réglage variable
identification-changing-setting = essais à réglage variable
identification-no-actuator = { $count ->
        [one] l’essai
       *[other] les { $count } essais
    } à réglage variable ({ $setting }) { $count ->
        [one] ne montre
       *[other] ne montrent
    } aucun actionneur : l’effort suit la commande dans la limite de l’échantillonnage et du bruit
identification-actuator-open = les mesures ne déterminent pas { $names } : les valeurs sont celles que montrent d’ordinaire les valves
identification-actuator-vague = les essais laissent { $names } incertain à plus de { $width } ms près. Ajouter des échelons de { $setting }, montants et descendants, entre plusieurs paires de réglages, pendant un mouvement rapide
identification-actuator-two-settings = les temps de la valve supposent que la force est linéaire selon { $setting } entre { $low } et { $high } : une force courbe les fausse au-delà de leurs intervalles. Mesurer un réglage entre les deux
identification-family-selected = la campagne compte { $all } essais, plus qu’une recherche n’en peut utiliser : { $selected } d’entre eux représentent l’ensemble, au plus { $most } par réglage et { $changing } dont le réglage varie, de chaque amplitude, vitesse, position moyenne, température et effort latéral. Les erreurs sur enregistrements entiers comptent tous les essais ; pour choisir soi-même, donner --exclude ou un dossier plus petit
identification-no-interval-between = { $names } : pas d’intervalle ici, entre deux réglages ; un ajustement à trois réglages ou plus montre l’erreur de l’interpolation
identification-label-suspect = { $test } indique { $name } { $stated }, mais ses forces sont celles de { $fitting } : au réglage indiqué, le modèle s’en écarte { $ratio } fois plus. Vérifier cette indication ; une valeur corrigée se met dans campaign.toml sous settings
identification-label-stray = { $test } indique { $name } { $stated }, mais ses forces sont celles de { $fitting } et non celles des réglages voisins. Vérifier cette indication ; une valeur corrigée se met dans campaign.toml sous settings
identification-setting-doubt = les efforts de { $test } sont ceux d’environ { $fitting }, non ceux de { $stated } : là, le modèle s’en écarte de { $fitting_error } N, ici de { $stated_error } N. Vérifier le réglage de l’essai et son unité
identification-labels-exchanged = l’effort d’amortissement ne croît ni ne décroît d’un bout à l’autre de { $name } ; il le ferait avec { $one } et { $other } échangés. Vérifier les indications de ces essais ; un amortisseur réellement ainsi est modélisé comme mesuré
identification-labels-opposed = sur { $name }, l’effort d’amortissement en { $direction } croît vers { $rising } mm/s et décroît vers { $falling } mm/s. Certains essais comptent peut-être { $name } depuis l’autre bout : vérifier leurs indications ; un amortisseur réellement ainsi est modélisé comme mesuré
identification-family-stores = un changement de { $setting } peut fournir un travail au véhicule, car il modifie une énergie accumulée ou une force au repos : { $sources }
identification-energy-of-number = { $name } { $range }
identification-energy-at-rest = la force de la courbe FV à vitesse nulle, { $range }
identification-energy-of-lag = la force retardée de { $element }
identification-energy-range = { $low } à { $low_at } jusqu’à { $high } à { $high_at }
identification-family-no-setting = aucun essai n’indique { $name }. L’écrire dans les noms de tous les essais (800mA, 12clicks, 150psi), donner sa colonne (--column setting=HEADING), donner l’unité d’une colonne de courant qui n’en a pas (--unit current=A), ou écrire setting et [settings] dans campaign.toml à côté{ $unread }
identification-family-unread = {" "}; { $note }
identification-family-other-setting = aucun essai n’indique { $name } ; les essais ont un réglage nommé { $known } : donner --setting avec ce nom
identification-family-without = { $name } manque pour { $tests } (essais : { $count }). Les écarter avec --exclude, nommer leur colonne (--column setting=HEADING), ou le donner dans campaign.toml sous settings{ $unread }
identification-family-one = tous les essais à { $name } constant ont la même valeur, { $value } : un modèle en fonction de ce réglage en demande au moins deux. Les ajuster sans --setting, ou vérifier l’unité de la colonne
identification-family-only-changing = { $name } varie pendant { $count ->
        [one] le seul essai
       *[other] chacun des { $count } essais
    } : un amortisseur s’ajuste à des essais à deux réglages constants au moins ; ceux où il varie identifient sa valve
identification-family-too-many = les essais ont { $count } valeurs de { $name }, et un modèle en contient { $most } : en écarter avec --exclude ou --hold-out, ou indiquer le réglage dans campaign.toml sous [settings]
identification-family-at = à { $name } = { $value } : { $why }
identification-family-kernel = les réglages ne font pas un modèle : { $parameter } { $why }
identification-family-not-finite = aucun effort fini n’a pu être calculé pour tous les réglages ensemble ; ajuster chacun à part pour trouver l’essai en cause

## What a fit says. Why there is no fit.

identification-no-tests = il n’y a aucun essai à ajuster : donner un dossier ou des fichiers avec au moins une mesure
identification-unknown-element = il n’y a pas d’élément { $name } ; les éléments sont { $known }
identification-not-fitted = fit n’identifie pas { $name } : dashpot diagnose l’ajoute au modèle ajusté où il le trouve, sinon à la main ; fit connaît { $known }
identification-other-family = { $name } est un modèle à part et n’admet aucun autre élément ; utiliser --model lag
identification-one-sided = les essais ne bougent jamais en { $direction } : une courbe effort-vitesse demande les deux sens
identification-not-finite = aucun effort fini n’a pu être calculé pour l’essai { $test } ; regarder ses voies (un saut du déplacement ?)

# What a diagnosis says.

## What a diagnosis says. How far a diagnosis is.

diagnosis-preparing = préparation des mesures
diagnosis-fitting-reference = ajustement du modèle à la référence
diagnosis-refitting = réajustement du modèle tel quel
diagnosis-each-effect = réajustement de l’ensemble avec chaque effet
diagnosis-weighing = pesée de chaque nom avec les autres présents
diagnosis-what-is-left = examen de ce qui reste
diagnosis-done = terminé

## What a diagnosis says. Why there is no diagnosis.

diagnosis-no-tests = il n’y a aucun essai à diagnostiquer : donner un dossier ou des fichiers avec au moins une mesure, et ne pas tout écarter
diagnosis-unknown-name = il n’y a pas d’effet { $name } ; les effets sont { $known }
diagnosis-nothing-to-compare = la campagne de référence n’a aucun des essais de celle-ci (mêmes amplitude, fréquence, déplacement moyen et effort latéral, à 5 % près) : mener la même matrice sur les deux amortisseurs{ $turned }
diagnosis-besides = { " " }; { $said }
diagnosis-opposite = la campagne a été lue comme comptant { $own } positivement, la référence comme comptant { $good } positivement ; si les deux viennent du même banc, lire les deux avec --positive rebound, ou les deux avec --positive compression
diagnosis-identical = les mêmes mesures, valeur pour valeur, sont dans la référence : { $tests } ; rien ne peut y avoir changé, vérifier donc que la référence est le bon dossier
diagnosis-not-finite = le modèle ne donne pas d’effort fini pour ces mesures : dashpot validate montre où

## What a diagnosis says. Lists.

diagnosis-comma = ,{ " " }
diagnosis-and = { " " }et{ " " }

## What a diagnosis says. The answer.

diagnosis-times = { $times } fois l’écart que laissent le bruit et la forme des courbes
diagnosis-name-and-sure = ‹le›{ $effect } (sûr à { $percent }{ $instead })
diagnosis-instead-of = , à la place ‹de›{ $effect }
diagnosis-has-effect = cet amortisseur montre { $names } ; { $residual }, { $rest }{ $also }
diagnosis-residual-falls = le résidu passe de { $before } à { $after } fois le bruit et l’erreur de courbe
diagnosis-residual-stays = le résidu ne baisse pas ({ $before } fois le bruit et l’erreur de courbe avant, { $after } fois après)
diagnosis-leaves-nothing = ce qui ne laisse rien d’inexpliqué
diagnosis-leaves-a-part = ce qui laisse une part inexpliquée
diagnosis-new-effect = nouveau sur cet amortisseur : { $names } ; { $residual }, { $rest }{ $also }
diagnosis-also-changed = { " " }; également changé : { $changes }
diagnosis-at-all-settings = à chaque réglage, cet amortisseur montre ‹le›{ $effect } (sûr à { $sure }{ $instead })
diagnosis-at-some-settings = ‹le›{ $effect } (sûr à { $sure }{ $instead }) manque au modèle à { $names } ; aux autres réglages il n’est pas nommé
diagnosis-only-together = aucun réglage à lui seul n’exige { $effects } ; un réglage en dit moins que tous ensemble, donc l’ajustement sur tous les réglages (dashpot fit --setting) décide si le modèle le garde
diagnosis-at-no-setting = à aucun réglage il ne manque au modèle un effet que ces enregistrements puissent nommer
diagnosis-changed-at-all-settings = { $name } a changé à chaque réglage (sûr à { $sure })
diagnosis-changed-at-some-settings = { $name } a changé à { $names } (sûr à { $sure }) ; aux autres réglages aucun changement n’en apparaît
diagnosis-changed-at-no-setting = à aucun réglage rien n’a changé que ces mesures puissent nommer
diagnosis-settings-not-in-model = le modèle n’a pas été mesuré à { $names } : ses valeurs y sont interpolées, et le diagnostic les ajuste d’abord à ces mesures. Il ne juge donc pas l’interpolation ; dashpot validate le fait
diagnosis-no-name-at-all-settings = à chaque réglage il manque quelque chose qui n’a pas encore de nom
diagnosis-no-name-at-some-settings = à { $names } il manque quelque chose qui n’a pas encore de nom
diagnosis-needless = aucun des effets examinés ne manque ; ces mesures ne demandent pas { $effects }
diagnosis-not-explained = { $percent } du désaccord ne sont pas expliqués par ce qui a été nommé : une autre forme, ou autre chose
diagnosis-immaterial = le modèle amélioré a en outre { $effects }, sans être nommé : dans aucun essai la force ne dépasse le bruit et 0,5 % de la force mesurée
diagnosis-test-and-times = { $test } ({ $times } fois)
diagnosis-detection-limit = le modèle s’écarte des cycles moyens de { $residual } N efficaces, et leur bruit est de { $noise } N : la différence compte comme forme de la courbe FV, et un effet de cette taille n’en est pas distinguable
diagnosis-still-missed = trop rare ou trop petit pour être nommé, mais ces essais sont manqués : { $tests }
diagnosis-nothing-missing = il ne manque aucun effet connu que ces mesures puissent montrer : le modèle s’écarte de { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-none-of-asked = aucun des effets demandés ({ $effects }) ne manque, pour autant que ces mesures puissent le montrer : le modèle s’écarte de { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-unchanged = rien n’a changé que ces mesures puissent montrer : le modèle de la référence s’écarte de { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-unchanged-of-asked = aucun nombre n’a changé et aucun des effets demandés ({ $effects }) n’est nouveau, pour autant que ces mesures puissent le montrer : le modèle de la référence s’écarte de { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-without-cause = { " " }; { $percent } de l’erreur quadratique moyenne n’ont pas de cause connue
diagnosis-likeliest = { " " }; le plus probable des effets absents du modèle est ‹le›{ $effect } (sûr à { $percent })
diagnosis-warmer = des essais étaient jusqu’à { $kelvin } K plus { $sense } que sur la référence ({ $test } : { $here } et { $there } °C en moyenne) : la force du gaz croît de 0,34 % par kelvin et l’huile chaude amortit moins, une partie de l’écart peut donc venir de la température, surtout une dérive du zéro de force ; comparez des campagnes de même température
diagnosis-warmer-sense = chaud
diagnosis-colder-sense = froid
diagnosis-changed = { $numbers }{ $more }
diagnosis-nothing-else = { " " }; rien d’autre n’a changé
diagnosis-nothing-else-large = { " " }; rien d’autre n’a changé de plus de 0,5 % de l’effort
diagnosis-more-may-have-changed = { " " }; davantage a pu changer, car le modèle s’écarte encore de { $times }
diagnosis-changed-both = effort d’amortissement { $percent } % en détente et en compression ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-changed-rebound = effort en détente { $percent } % à toutes les vitesses ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-changed-compression = effort en compression { $percent } % à toutes les vitesses ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-changed-rebound-low = effort en détente à basse vitesse { $percent } % ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-changed-compression-low = effort en compression à basse vitesse { $percent } % ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-changed-rebound-high = effort en détente à haute vitesse { $percent } % ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-changed-compression-high = effort en compression à haute vitesse { $percent } % ({ $reference } → { $value } N à { $velocity } mm/s)
diagnosis-other-number = { $name } { $reference } → { $value }
diagnosis-uncertain-change = { $change } (incertain : l’intervalle à 95 %, { $low } à { $high } { $unit }, contient la référence)
diagnosis-more-numbers = { " " }et { $count } autres
diagnosis-cannot-show = { " " }; elles ne peuvent montrer { $effects }
diagnosis-not-confirmed = { " " }; aucun essai n’a été mis de côté pour le confirmer
diagnosis-cannot-tell = il manque quelque chose : le modèle s’écarte de { $times }, et { $why }
diagnosis-too-few-tests = ‹le›{ $effect } est le plus probable, mais trop peu d’essais l’appuient pour le nommer
diagnosis-not-apart = ces mesures ne peuvent distinguer { $effects }
diagnosis-unknown-effect = le modèle s’écarte de { $times }, et aucun des effets connus n’est assez probable pour l’expliquer{ $nearest }
diagnosis-looks-like = { " " }; cela ressemble à { $what }
diagnosis-nearest = { " " }; le plus proche, ‹le›{ $effect }, explique { $percent }
diagnosis-explains = explique { $percent } du désaccord

## What a diagnosis says. What a disagreement without a name looks like.

diagnosis-like-guides = un frottement qui croît avec l’effort, comme en fait dans les guides une traverse ou un œil de travers
diagnosis-like-load-cell = une boucle selon l’effort quelle que soit la vitesse, comme en trace un capteur d’effort à hystérésis
diagnosis-like-resonance = une résonance dans le chemin de l’effort, comme celle d’un bâti ou de l’huile dans un flexible

## What a diagnosis says. Regions.

diagnosis-region = { $direction }, { $slow }–{ $fast } mm/s{ $phase }, { $place } : { $missing } (efficace { $rms } N, bruit { $noise } N)
diagnosis-rebound = détente
diagnosis-compression = compression
diagnosis-speeding-up = { " " }en accélérant
diagnosis-slowing-down = { " " }en ralentissant
diagnosis-in-all-tests = dans tous les essais qui y passent
diagnosis-in-test = dans l’essai { $test }
diagnosis-more-tensile = l’effort mesuré est de { $mean } ± { $error } N plus en traction que l’effort calculé
diagnosis-more-compressive = l’effort mesuré est de { $mean } ± { $error } N plus en compression que l’effort calculé
diagnosis-off-both-ways = l’effort mesuré est tantôt supérieur, tantôt inférieur à l’effort calculé

## What a diagnosis says. Tests that would tell more.

diagnosis-run-sine = réaliser un sinus de { $amplitude } { $unit } à { $frequency } Hz{ $about }{ $under } : { $a } et { $b } y diffèrent de { $difference } N efficaces
diagnosis-about-mean = { " " }autour de { $mean } { $unit } au compte des fichiers
diagnosis-under-side-force = { " " }sous { $force } N d’effort latéral
diagnosis-shows-best = ‹le›{ $effect } se montre le mieux ainsi : { $remedy }
diagnosis-no-trace = à un niveau habituel, il ne laisserait pas de trace dans ces essais : { $remedy }
diagnosis-sum-alone = le tube s’élargit avec la pression comme cède la colonne d’huile : un banc montre leur somme, que représente la compressibilité de l’huile (oil_compressibility)

## What a diagnosis says. The test that shows an effect best.

diagnosis-show-more = plus d’amplitudes et de fréquences
diagnosis-show-slow = triangles lents de { $slow } à { $fast } { $speed_unit }, deux courses, deux températures
diagnosis-show-spring = parcourir lentement toute la course, et une fois à 1 Hz, à deux positions moyennes
diagnosis-show-gas-warming = l’effort au repos au milieu de la course, à froid et après une forte sollicitation, en enregistrant la température
diagnosis-show-mount = sinus de { $small } à { $large } { $unit } de { $low } à { $high } Hz
diagnosis-show-zero = lire l’effort au repos, avec et sans l’amortisseur accroché
diagnosis-show-presliding = courses de { $small } à { $large } { $unit } à { $low } et { $high } Hz : des boucles égales l’indiquent
diagnosis-show-side-force = le même sinus sous 0, { $half } et { $full } N d’effort latéral
diagnosis-show-oil = une même vitesse de pointe à plusieurs courses et fréquences, à deux positions moyennes
diagnosis-show-aeration = un essai après une nuit de repos et après 200 cycles
diagnosis-show-cavitation = une même vitesse de pointe à plusieurs courses, avec la pression de gaz augmentée
diagnosis-show-fade = un essai de référence répété à froid et à chaud, en ordre mélangé, avec la température enregistrée
diagnosis-show-position = sinus de { $small } à { $large } { $unit } à cinq positions moyennes ou plus
diagnosis-show-bump-stop = pousser lentement dans la butée, vers { $lowest } { $unit } au compte des fichiers, puis à deux vitesses
diagnosis-show-rebound-stop = tirer lentement dans la butée, vers { $highest } { $unit } au compte des fichiers, puis à deux vitesses
diagnosis-show-free-play = de petites courses avec une précharge qui empêche l’effort de passer par zéro, et sans
diagnosis-show-frequency = une même vitesse de pointe à cinq fréquences de { $low } à { $high } Hz
diagnosis-show-valve = des rampes de vitesse lentes à travers le coude, en montant et en descendant
diagnosis-show-mass = faire tourner le banc sans l’amortisseur
diagnosis-show-delay = monter un ressort à la place de l’amortisseur : sa boucle doit se fermer
diagnosis-show-drift = répéter un essai de référence au début, au milieu et à la fin
diagnosis-semicolon = { " " };{ " " }
diagnosis-beyond = { $test } (au-delà de ce que ces essais ont atteint : { $demands })
diagnosis-beyond-amplitude = ±{ $value } { $unit } au lieu de ±{ $reached } { $unit }
diagnosis-beyond-speed = { $value } { $unit } au lieu de { $reached } { $unit }
diagnosis-beyond-frequency = { $value } { $unit } au lieu de { $reached } { $unit }
diagnosis-beyond-side-force = un effort latéral de { $value } { $unit } au lieu de { $reached } { $unit }

## What a diagnosis says. Why records cannot show an effect.

diagnosis-needs-series = il fait partie du chemin en série : le modèle a d’abord besoin de la souplesse en série (series_compliance)
diagnosis-series-added = il lui faut series_compliance, que ce diagnostic vient d’ajouter : relancer dashpot diagnose sur le modèle amélioré
diagnosis-needs-fixed-curve = une courbe FV libre absorbe un terme en v² : il faut que la courbe soit fixée par une spécification
diagnosis-needs-side-force = l’effort latéral ne varie pas : réaliser le même sinus sous deux efforts latéraux ou plus, en enregistrant la voie
diagnosis-needs-temperature = aucune voie de température ne varie, et les horloges des mesures ne montrent pas d’échauffement : enregistrer la température de l’huile ou du tube, ou répéter un essai à froid et après une forte sollicitation
diagnosis-needs-measured-temperature = aucune voie de température ne varie : enregistrer la température de l’huile ou du tube dans tous les essais
diagnosis-needs-places = tous les essais passent aux mêmes endroits aux mêmes vitesses : réaliser un petit sinus à cinq positions moyennes ou plus, ou une même vitesse de pointe à plusieurs courses
diagnosis-only-within-compression = seulement jusqu’à { $lowest } { $unit } en compression, au compte des fichiers : pousser lentement au-delà de ce que ces essais ont atteint pour y voir une butée
diagnosis-only-within-extension = seulement jusqu’à { $highest } { $unit } en détente, au compte des fichiers : tirer lentement au-delà de ce que ces essais ont atteint pour y voir une butée
diagnosis-needs-frequencies = les fréquences des essais sont presque les mêmes : réaliser une même vitesse de pointe à cinq fréquences de { $low } à { $high } Hz
diagnosis-needs-zero = une erreur de zéro du capteur d’effort et l’effort du gaz sont la même constante : lire le capteur avec l’amortisseur décroché, avant et après
diagnosis-needs-one-clock = chaque mesure remet son horloge à zéro : garder une seule horloge pendant la campagne et répéter un essai de référence

## What a diagnosis says. What is said of the improved model.

diagnosis-diagnosis = diagnostic : { $answer }
diagnosis-added = { $effect } (sûr à { $percent }) ajouté à ce modèle
diagnosis-of-the-rig = { $effect } (sûr à { $percent }) du banc : corrigé dans la comparaison, pas dans l’amortisseur de ce modèle
diagnosis-or-warm-gas = aucune température ne varie dans toutes les mesures : un gaz qui chauffe au fil de la campagne fait baisser l’effort au repos comme un zéro qui dérive, et ne s’en distingue pas. Enregistrer la température de l’huile ou du tube
diagnosis-all-fitted-tests = tous les essais ajustés

## What a diagnosis says. How the comparison was made.

diagnosis-without-reference = sans campagne de référence, un nom peut désigner ce que la forme du modèle ne rend jamais ; là où un bon amortisseur a été mesuré sur le même banc, --reference demande ce qui a changé
diagnosis-against-reference = comparé à la campagne de référence : ce que le modèle y laisse des mêmes essais est retiré{ $nearest }{ $aside }
diagnosis-by-nearest-motion = { " " }; les essais sans équivalent de même mouvement ont été comparés par l’erreur de forme du plus proche : { $tests }
diagnosis-without-counterpart = { " " }; la référence n’a aucun mouvement semblable, l’erreur de forme du modèle y reste donc : { $tests }

# What is said of the dimensions of a damper.

## What is said of the dimensions of a damper. Why a quantity cannot be told.

dimensions-no-gas-force = le modèle n’a pas d’effort de gaz ; un essai lent le montre
dimensions-gas-force-open = les mesures laissent l’effort de gaz ouvert ; un essai lent le montre
dimensions-gas-on-rod = le gaz pousse sur la section de la tige
dimensions-no-gas-spring = le modèle n’a pas de ressort à gaz ; des courses lentes sur tout le débattement le montrent
dimensions-gas-spring-open = les mesures laissent la raideur du gaz ouverte ; des courses lentes sur tout le débattement la montrent
dimensions-volume-from = il découle de la pression et de la raideur du gaz
dimensions-column-from = la raideur de la colonne est celle d’une chambre de section et de longueur données
dimensions-no-column = le modèle n’a ni colonne d’huile ni ressort en série que les mesures déterminent
dimensions-eyes-too-soft = les œillets indiqués sont, dans leur tolérance, plus souples que les œillets et l’huile ensemble dans le modèle
dimensions-no-modulus = le module effectif n’est pas connu
dimensions-tube-expands = le tube se dilate avec l’huile
dimensions-stroke-from = la course que cède l’air dépend de sa pression et de la longueur de la chambre
dimensions-air-from = c’est ce qui manque au module de l’huile, ou la course de l’élément aeration
dimensions-passage-from = un passage découle de la table FV et de la section du piston
dimensions-few-slow-points = moins de deux points de la table FV se trouvent sous le coude de cette course
dimensions-no-knee = la table FV de cette course n’a pas de coude : aucun clapet ne s’est ouvert
dimensions-bleed-passes-all = la fuite calibrée laisse passer tout le débit

## What is said of the dimensions of a damper. What else is to know of a quantity.

dimensions-by-compression = d’après la colonne en compression
dimensions-less-the-eyes = le ressort en série sans les œillets
dimensions-column-bound = une borne : la colonne d’huile contient aussi les œillets ; eye_stiffness_n_mm ou un ressort en série dans le modèle les sépare
dimensions-column-less-the-eyes = la colonne d’huile sans les œillets, car le modèle n’a pas de ressort en série
dimensions-a-bound = une borne : le ressort en série contient œillets et huile ; eye_stiffness_n_mm ou une colonne d’huile dans le modèle les sépare
dimensions-with-air = avec l’air qu’elle contient
dimensions-no-orifice = aucun orifice n’apparaît à côté de la fuite
dimensions-of-all-passages = de tous les passages laminaires ensemble : un jeu fuit au plus autant
dimensions-spring-is-more-than-gas = si le ressort en parallèle est le gaz ; les { $drawn } cm³ du dessin donnent environ { $percent } % de ce ressort, et un autre ressort le reste
dimensions-if-spring-is-gas = si le ressort en parallèle est le gaz
dimensions-no-leak = aucune fuite n’apparaît à côté de l’orifice
dimensions-opening-at = ouverture au plus grand effort de la table
dimensions-in-doubt = utilise { $entries } selon le plan, ce que la contradiction ci-dessous met en doute
dimensions-had-prior = l’ajustement avait pour cela un a priori tiré des dimensions
dimensions-doubtful-effect = seulement si l’amortisseur a { $effect }, dont la probabilité dans l’identification est de { $probability }
dimensions-comma = ,{ " " }
dimensions-semicolon = { " " };{ " " }

## What is said of the dimensions of a damper. What contradicts.

dimensions-contradicts-one = { $noun } du modèle : { $model }, soit { $ratio } fois les { $dimensions } que donne { $facts }. { $cause }
dimensions-contradicts-several = { $noun } du modèle : { $model }, soit { $ratio } fois les { $dimensions } que donnent { $facts }. { $cause }
dimensions-contradicts-zero = { $noun } du modèle : { $model }, ce qui contredit les { $dimensions } de { $facts }. { $cause }
dimensions-explained-by = Le plus petit changement d’une seule entrée du plan qui l’explique est { $entry } = { $value }.
dimensions-no-cause = Aucune entrée du plan ne l’explique à elle seule.
dimensions-pressure-on-rod = { $pressure } bar sur une tige de { $diameter } mm

## Words in sentences. Words of records.

word-rebound = détente
word-compression = compression
word-time = temps
word-force = effort
word-displacement-or-velocity = le déplacement ou la vitesse
word-an-incomplete-cycle-or-run-down = un cycle incomplet ou l’arrêt progressif
word-rest = repos
word-nothing = rien
word-current = courant
word-clicks = crans
word-voltage = tension
word-pressure = pression

## Words in sentences. Kinds of tests.

word-slow-tests = essais lents
word-small-strokes = petites courses
word-large-strokes = grandes courses

## Words in sentences. Paths and families of effects.

word-gas-and-springs = gaz et ressorts
word-constant-force = effort constant
word-spring = ressort
word-gas-temperature = température du gaz
word-friction = frottement
word-dry-friction = frottement sec
word-viscous-friction = frottement visqueux
word-friction-under-load = frottement sous charge
word-series = en série
word-mount = fixation
word-hydraulic = hydraulique
word-oil-column = colonne d’huile
word-void = vide
word-oil-temperature = température de l’huile
word-valves = clapets
word-stop = butée
word-rig = banc
word-mass = masse
word-timing = synchronisation
word-load-cell = capteur d’effort

## Words in sentences. Forms of effects.

word-changed = changé
word-full = complète
word-simplified = simplifiée
word-slips-from-the-first = glisse dès le début
word-bends-before-it-slips = fléchit avant de glisser
word-relaxes = se relâche
word-friction-in-the-rubber = frottement dans le caoutchouc
word-relaxes-over-decades-and-meets-a-stop = se relâche sur des décades et rencontre une butée
word-friction-in-the-rubber-and-a-stop = frottement dans le caoutchouc, et une butée
word-opens-under-a-load = s’ouvre sous une charge
word-all-of-the-force-goes-through-it = tout l’effort y passe
word-friction-and-gas-act-behind-it = le frottement et le gaz agissent derrière
word-relaxes-and-all-of-the-force-goes-through-it = se relâche, et tout l’effort y passe
word-friction-in-the-rubber-and-all-of-the-force-goes-through-it = frottement dans le caoutchouc, et tout l’effort y passe
word-rebound-chamber = chambre de détente
word-both-chambers = les deux chambres
word-one-chamber-softer-than-the-other = une chambre plus souple que l’autre
word-compression-capped-gas-pushes-on = compression plafonnée, le gaz continue de pousser
word-compression-capped-dead-return = compression plafonnée, retour mort
word-rebound-capped-force-stays = détente plafonnée, l’effort reste
word-rebound-capped-dead-return = détente plafonnée, retour mort
word-compression-capped-gas-expands-in-the-void = compression plafonnée, le gaz se détend dans le vide
word-foot-valve-does-not-refill = le clapet de pied ne remplit pas
word-measured-temperature = température mesurée
word-oil-warmer-than-measured = huile plus chaude que mesurée
word-heated-by-its-own-work = chauffée par son propre travail
word-rebound-chamber-is-not-refilled = la chambre de détente n’est pas remplie
word-rebound-begins-with-a-lost-stroke = la détente commence par une course morte
word-compression-begins-with-a-lost-stroke = la compression commence par une course morte
word-isothermal = isotherme
word-takes-time-to-cool = met du temps à refroidir
word-both-strokes = les deux courses
word-groove = rainure
word-groove-open-in-rebound = rainure ouverte en détente
word-groove-open-in-compression = rainure ouverte en compression
word-bypass = dérivation
word-filter = filtre
word-stroke = course
word-a-valve-with-play = un clapet avec jeu
word-a-valve-with-mass = un clapet avec masse
word-opens-and-closes-at-different-forces = s’ouvre et se ferme à des efforts différents
word-linear = linéaire
word-quadratic = quadratique
word-cubic = cubique
word-quartic = du quatrième degré
word-rubber = caoutchouc
word-hydraulic-gap = hydraulique, fente
word-hydraulic-orifice = hydraulique, orifice calibré
word-on-the-load-cell = sur le capteur d’effort
word-at-the-load-cell = au capteur d’effort
word-inside-like-oil-in-a-long-passage = à l’intérieur, comme l’huile dans un long passage
word-low-pass-filter-of-the-force-channel = filtre passe-bas de la voie d’effort
word-zero-set-anew-during-the-campaign = zéro refait pendant la campagne
word-settles-as-the-rig-warms-up = se stabilise quand le banc chauffe

## Words in sentences. Quantities of the dimensions, and units that are words.

word-gas-pressure = pression du gaz
word-gas-volume = volume de gaz
word-effective-modulus-of-the-oil = module effectif de l’huile
word-modulus-of-the-oil = module de l’huile
word-air-content-of-the-oil = teneur en air de l’huile
word-bleed-area-in-rebound = section de fuite en détente
word-bleed-area-in-compression = section de fuite en compression
word-leak-in-rebound = fuite en détente
word-leak-in-compression = fuite en compression
word-blow-off-area-in-rebound = section de clapet en détente
word-blow-off-area-in-compression = section de clapet en compression
word-gas-force = effort de gaz
word-growth-of-the-gas-force-with-temperature = croissance de l’effort de gaz avec la température
word-gas-stiffness = raideur du gaz
word-length-of-the-gas-column = longueur de la colonne de gaz
word-cavitation-cap = limite de cavitation
word-stiffness-of-the-oil-column = raideur de la colonne d’huile
word-shortening-of-the-oil-column = raccourcissement de la colonne d’huile
word-stiffness-of-the-oil-column-in-compression-over-that-in-rebound = raideur de la colonne d’huile en compression sur celle en détente
word-force-that-halves-the-air-s-stroke = effort qui réduit de moitié la course de l’air
word-stroke-that-the-air-yields = course que cède l’air
word-series-stiffness = raideur en série
word-parallel-spring = ressort en parallèle
word-bar-gauge = bar relatif
word-at-1-013-bar-absolute = % à 1,013 bar absolu
word-fv-force-at-two-slow-speeds = fv_force à deux vitesses lentes
word-fv-force-at-a-fast-speed = fv_force à une vitesse rapide
word-oil-stiffness-or-aeration-stroke = oil_stiffness ou aeration_stroke
