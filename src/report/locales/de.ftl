### Texts of the reports: German.

## The page.

decimal-sign = ,
note = Hinweis.
all-tests-shown = alle Versuche
previous = zurück
next = weiter
test-shown = Gezeigter Versuch
figure-help = Im Bild ziehen vergrößert, Doppelklick zeigt wieder alles, der Zeiger liest Werte ab.
zoom-reset = ganzes Bild
save-table = als CSV speichern
save-about = Semikolons zwischen den Spalten und Dezimalkommas: Excel öffnet die Datei so in Spalten.
sort-help = Ein Klick auf eine Überschrift sortiert.
printed-brief = Gedruckt sind das Ergebnis und seine Belege. Die Datei selbst enthält jeden Versuch und jede Tabelle; ein mit --full erzeugter Bericht druckt alles.

## Figures.

measured = gemessen
model = Modell
fv-curve = FV-Kurve
noise-alone = nur Rauschen
axis-velocity = Geschwindigkeit, mm/s
axis-displacement = Weg, mm
axis-force = Kraft, N
axis-error = berechnet − gemessen, N
axis-time = Zeit, s
axis-gap = steigende − fallende Geschwindigkeit, N
axis-error-percent = Fehler, %
axis-peak-velocity = Spitzengeschwindigkeit, mm/s
axis-amplitude = Amplitude, mm
plot-force-velocity = Kraft über Geschwindigkeit
plot-force-displacement = Kraft über Weg
plot-force-time = Kraft über Zeit
plot-error-velocity = Fehler über Geschwindigkeit
plot-error-displacement = Fehler über Weg
plot-force-space = Kraft über Geschwindigkeit und Weg
plot-error-space = Fehler über Geschwindigkeit und Weg
plot-gap = Abstand der Hysterese über Geschwindigkeit
plot-error-of-tests = Fehler jedes Versuchs, % seiner größten Kraft
plot-error-map = Fehler nach Amplitude und Spitzengeschwindigkeit, %
plot-error-map-note = groß: { $model }, klein: { $curve } allein
plot-both-curves = FV-Kurven beider Dämpfer, mit Reibung und Gaskraft
plot-peaks = Spitzenkraft über Spitzengeschwindigkeit
identified-curve = ermittelte Kurve mit Reibung und Gaskraft
measured-peaks = gemessene Spitzen
model-peaks = Spitzen des Modells
window = Grenzwerte

## Validation: title and answer.

title-validation = Dämpfermodell und Prüfstandsmessung
subtitle-validation = Modell { $model } gegen die Messungen in { $data }
answer = Ergebnis
over-one-test = In dem einen Versuch
over-tests = Über { $tests } Versuche
headline = { $over } weicht das Modell im Mittel um { $error } N von der gemessenen Kraft ab, das sind { $percent } % der größten Kraft eines Versuchs. Die Kraft-Geschwindigkeits-Kurve allein weicht um { $curve_error } N ab, das sind { $curve_percent } %: { $verdict }{ $closer }.
verdict-exact = das Modell folgt der Messung genau
verdict-smaller = der mittlere Fehler des Modells ist um den Faktor { $ratio } kleiner
verdict-same = das Modell ist nicht nennenswert besser als die Kurve
verdict-larger = der mittlere Fehler des Modells ist um den Faktor { $ratio } größer: es ist schlechter als die Kurve
closer-in = , und es liegt in { $closer } von { $tests } Versuchen näher an der Messung
left-out-figures = { $error } N oder { $percent } % (Kurve allein { $curve_error } N oder { $curve_percent } %)
left-out-sentence = In den { $left } Versuchen, die die Identifikation nicht gesehen hat, beträgt der mittlere Fehler { $left_figures }; in den { $fitted }, an die angepasst wurde, { $fitted_figures }.
only-fitted = Alle Versuche wurden zur Identifikation verwendet; die Zahlen zeigen also, wie gut das Modell passt, nicht wie gut es vorhersagt.
largest-error = Den größten Fehler in Prozent hat der Versuch „{ $test }“: { $percent } %, das sind { $error } N von { $force } N.
noise-sentence = Das Rauschen der gemessenen Kraft allein ergäbe einen mittleren Fehler von etwa { $noise } N; genauer kann kein Modell sein.

## Its sections.

fv-section = FV-Kurve über den gemessenen Spitzen
fv-caption-by-setting = Jeder Punkt ist die Kraft eines Versuchs bei seiner Spitzengeschwindigkeit, gemittelt über die Zyklen, bei der Einstellung des Versuchs.
fv-caption = Jeder Punkt ist die Kraft eines Versuchs bei seiner Spitzengeschwindigkeit, gemittelt über die Zyklen. Die Linie zeigt, was das Modell bei konstanter Geschwindigkeit ergibt: FV-Kurve, Reibung und Gaskraft. Wo Punkte neben der Linie liegen, hängt der Dämpfer nicht nur von der Geschwindigkeit ab.
worst-section = Schlechtester Versuch: { $test }
worst-caption = Der Versuch mit dem größten Fehler in Prozent seiner Kraft.
matrix-section = Fehler nach Amplitude und Spitzengeschwindigkeit
key-section = Fehler in Zahlen
tests-section = Fehler jedes Versuchs
single-section = Einzelne Versuche
single-about = Nach Fehler geordnet, der schlechteste zuerst. Schleifen zeigen die letzten { $cycles } ganzen Zyklen; ein Versuch ohne ganze Zyklen wird ganz gezeigt. Fehler sind berechnet minus gemessen. Der Abstand der Hysterese ist über alle ganzen Zyklen gemittelt.
single-most = Von { $tests } Versuchen sind die { $shown } mit den größten Fehlern gezeigt.
hysteresis-section = Hysterese
identification-section = Identifikation
parameters-section = Parameter des Modells
parameters-range = Unten und oben sind die Enden des 95-%-Bereichs.
made-section = Wie dieser Bericht entstand

## Tables.

col-tests = Versuche
col-number = Anzahl
col-force-of = Kraft von
col-mean-error = mittlerer Fehler, N
col-error-percent = Fehler, %
col-region1 = Bereich 1, N
col-region2 = Bereich 2, N
col-rms = Effektivwert, N
col-test = Versuch
col-amplitude = Amplitude, mm
col-frequency = Frequenz, Hz
col-peak-velocity = Spitzengeschw., mm/s
col-max-force = größte Kraft, N
col-in-fit = angepasst
yes = ja
no = nein
group-curve = FV-Kurve allein
all-tests = alle Versuche
used-in-fit = zur Anpassung verwendet
left-out-of-fit = nicht zur Anpassung verwendet
key-caption = Mittlerer Fehler: Mittel von |berechnet − gemessen| über die Abtastwerte eines Versuchs. Fehler in Prozent der größten gemessenen Kraft des Versuchs. Bereiche 1 und 2: die Anteile des mittleren Fehlers aus Abtastwerten langsamer und schneller als { $boundary } mm/s; zusammen ergeben sie ihn. Der Effektivwert (Wurzel des mittleren Quadrats) gewichtet große Abweichungen stärker. Alles sind Mittel über die Versuche, jeder mit gleichem Gewicht.
row-rule = Jeder Versuch hat in seiner Zeile gleiches Gewicht; das Prozent bezieht sich auf die größte Kraft der Zeile.
by-amplitude = Versuche gleicher Amplitude zusammen. { $rule }
by-peak-velocity = Versuche gleicher Spitzengeschwindigkeit zusammen. { $rule }
tests-caption = Jeder Versuch für sich; das Prozent bezieht sich auf seine eigene größte Kraft.
row-amplitude = { $value } mm Amplitude
row-peak-velocity = { $value } mm/s Spitzengeschwindigkeit
row-slow = langsame Reibversuche, unter { $value } mm/s
row-not-periodic = Versuche ohne ganze Zyklen
col-cycles = Zyklen
group-gap = mittlerer Abstand, N
group-gap-error = Fehler des Abstands, N
group-area = Schleifenfläche ∮F dv, N·m/s
group-energy = Energie ∮F dx, J
col-measured = gemessen
col-curve = Kurve
hysteresis-caption = Mittel über ganze Zyklen. Abstand: Unterschied der Kraft bei steigender und bei fallender Geschwindigkeit, bei gleicher Geschwindigkeit; sein Betrag ist über die Geschwindigkeiten des Versuchs gemittelt. Fehler des Abstands: Mittel von |berechneter Abstand − gemessener Abstand|. Eine negative Schleifenfläche heißt, dass die Kraft der Geschwindigkeit nacheilt (Gas und Nachgiebigkeit des Öls), eine positive, dass sie vorauseilt (bewegte Masse).
col-name = Name
col-value = Wert
col-unit = Einheit
col-low = unten
col-high = oben
col-source = Herkunft
parameter-at = bei { $place }
col-note = Bemerkung
not-identified = aus diesen Daten nicht bestimmbar
not-identified-assumed = nicht bestimmbar: angenommen { $value }, { $source }
not-identified-off = nicht bestimmbar: das Element ist aus ({ $why })
assumed-usual = wie es Dämpfer zeigen ({ $source })
assumed-dimensions = nach den Maßen ({ $source })
assumed-default = die Vorgabe des Modells
assumed-held = die Messungen bestimmen ihn nicht; er liegt zwischen üblichem und angepasstem Wert

## Single tests.

notes-of-test = Beim Einlesen und Bereinigen geändert oder bemerkt:
motion-periodic = { $amplitude } mm Amplitude bei { $frequency } Hz, Spitzengeschwindigkeit { $velocity } mm/s, { $cycles } ganze Zyklen.
motion-other = Nicht periodisch, Spitzengeschwindigkeit { $velocity } mm/s.
temperature = Temperatur { $first } °C am Anfang, { $last } °C am Ende.
force-noise = Rauschen der Kraft { $noise } N effektiv.
test-used = Zur Anpassung verwendet.
test-left-out = Nicht zur Anpassung verwendet.
test-sentence = Größte Kraft { $force } N. Mittlerer Fehler des Modells { $error } N, { $percent } %; der Kraft-Geschwindigkeits-Kurve allein { $curve_error } N, { $curve_percent } %.

## The literature.

family-section = Über der Einstellung
family-between = Eine Familie, die { $at } nicht gesehen hat, liegt dort um { $error } N ({ $percent }) daneben, { $ratio } mal so viel wie eine Anpassung an { $at } allein.
family-between-worse = Zwischen seinen Einstellungen ist das Modell schlechter als bei ihnen: Eine Familie, die { $at } nicht gesehen hat, liegt dort um { $error } N ({ $percent }) daneben, { $ratio } mal so viel wie eine Anpassung an { $at } allein. Messungen zwischen { $at } und den Nachbarn helfen am meisten.
family-about = Der Dämpfer hängt von einer Einstellung ab. In jedem Versuch ist es die des Versuchs; zwischen den Einstellungen der Modelldatei wird interpoliert.
family-interpolated = { $setting } (interpoliert)
plot-family = Kraft bei konstanter Geschwindigkeit, nach Einstellung
family-caption = Eine Kurve für jede Einstellung der Modelldatei, gestrichelt für Einstellungen der Versuche dazwischen. Punkte sind die gemessenen Kräfte bei Spitzengeschwindigkeit, in der Farbe ihrer Einstellung.
family-table = Mittel über die Versuche jeder Einstellung. Die FV-Kurve ist an die Versuche dieser Einstellung angepasst.
family-clamped = { $setting } (begrenzt)
family-errors-section = Fehler bei jeder Einstellung
family-left-out-table = Mittlerer Fehler über die mittleren Zyklen der angepassten Versuche. Die Familie ohne eine Einstellung ist an alle anderen angepasst und interpoliert; an den Enden des Gitters gibt es keine.
family-own-fit = Anpassung an sie allein
family-fit = Familie
family-without = Familie ohne sie
col-ratio = Verhältnis
family-loops-section = Schleifen nach Einstellung
family-loops-about = Eine Bewegung bei jeder Einstellung, die sie hat: { $amplitude } mm Amplitude, Spitzengeschwindigkeit { $velocity } mm/s.
family-worst-about = Darunter bei jeder Einstellung der Versuch mit dem größten Fehler in Prozent.
family-worst-caption = { $setting }: { $test }, mittlerer Fehler { $error } N, { $percent } %
plot-over-setting = Kraft über der Einstellung
over-setting-caption = Kraft des Modells bei konstanter Geschwindigkeit. Eine waagerechte Linie hängt nicht von der Einstellung ab.
plot-ratio = Verhältnis härteste zu weichster
ratio-caption = Kraft bei { $hard } durch Kraft bei { $soft }, mit Reibung, ohne Gaskraft, bei den Spitzengeschwindigkeiten der Versuche.
axis-speed = Betrag der Geschwindigkeit, mm/s
axis-ratio = Verhältnis, -
number-varies = (hängt von der Einstellung ab; Balken sind 95-%-Intervalle, ein Wert ohne Balken ist nicht identifiziert)
number-shared = (allen Einstellungen gemeinsam; Balken sind das 95-%-Intervall)
family-numbers-section = Zahlen über der Einstellung
family-numbers-table = Was von der Einstellung abhängt, mit 95-%-Intervallen, wo eine Anpassung sie hinterlassen hat.
family-varies = hängt ab
family-effects = Was jeder Effekt bei jeder Einstellung trägt: was sein Entfernen ändert, alles andere bleibt.
family-dependences = Was von der Einstellung abhängt, mit der Wahrscheinlichkeit dafür.
responses-section = Antwort auf Sprünge der Einstellung
responses-about = Entlang der Bewegung jedes Versuchs sind die Kraft bei der Einstellung vor einem Sprung und die bei der danach aus dem Modell bekannt. Die Antwort ist der Anteil des Weges dazwischen, den die Kraft gegangen ist; so zählt ein Sprung im Sinus wie bei konstanter Geschwindigkeit.
responses-table = Mittlere Antwort auf alle Sprünge zwischen denselben zwei Einstellungen, gemessen und nach dem Modell. Zeiten zählen ab dem Sprung; die ab 10 % enthalten keine Totzeit.
col-step = Sprung
col-steps = Sprünge
col-t63 = bis 63 %, ms
col-t90 = bis 90 %, ms
col-t63-from-10 = 10 bis 63 %, ms
col-t90-from-10 = 10 bis 90 %, ms
col-overshoot = Überschwingen, %
plot-step-up = Antwort auf einen Sprung aufwärts
plot-step-down = Antwort auf einen Sprung abwärts
axis-since-step = Zeit seit dem Sprung, ms
axis-way = Anteil des Weges, -
actuator-table = Zahlen des Stellers, mit 95-%-Intervallen, wo eine Anpassung sie hinterlassen hat.
actuator-parts = Was das Ventil hat, mit der Wahrscheinlichkeit dafür.
col-has-it = hat es
plot-hysteresis-setting = Hysterese über der Einstellung
hysteresis-setting-caption = Kraft des Modells bei { $velocity } mm/s, während die Einstellung langsam steigt und fällt. Das Ventil bleibt auf dem Weg nach oben um { $hysteresis } zurück und eilt auf dem Weg nach unten so weit voraus.
way-up = aufwärts
way-down = abwärts
family-changing = veränderlich
response-time-up = Antwort auf einen Sprung aufwärts, bis 63 %, ms
response-time-down = Antwort auf einen Sprung abwärts, bis 63 %, ms
rise-time-up = Antwort auf einen Sprung aufwärts, 10 bis 90 %, ms
rise-time-down = Antwort auf einen Sprung abwärts, 10 bis 90 %, ms
settings-section = Über die Einstellungen
settings-all = alle
settings-caption = Jeder Effekt des Dämpfers bei den Einstellungen, jede für sich diagnostiziert: Wahrscheinlichkeit und Kraft bei jeder. Ein Effekt aller Einstellungen steht einmal da.
settings-changes = Was sich gegenüber der Referenz bei den Einstellungen geändert hat, jede für sich verglichen: Wert vorher und nachher, Wahrscheinlichkeit und Kraft bei jeder.
settings-answers = Die Antwort bei jeder Einstellung. N effektiv über die mittleren Zyklen ihrer Versuche: bevor ein Effekt hinzukommt, danach, und was Rauschen ausmacht.
col-setting = Einstellung
against-section = Vergleich mit der Literatur
against-about = Jedes Modell ist mit kleinsten Quadraten von mehreren Startwerten aus an denselben Versuchen bestimmt wie das geprüfte Modell und dann auf die übrigen angewendet. Effektivwert und mittlerer Fehler sind Mittel über die Versuche.
against-caption = Fehler in Prozent der größten gemessenen Kraft jedes Versuchs.
col-model = Modell
col-meaning = was es ist

## Limits.

certificate-title = Prüfbescheinigung: Dämpfer gegen seine Grenzwerte
certificate-subtitle = Messungen in { $data }, Grenzwerte aus { $limits }
certificate-section = Grenzwerte
certificate-pass = BESTANDEN. Der Dämpfer hält alle Grenzwerte ein ({ $count }).
certificate-fail = NICHT BESTANDEN. Der Dämpfer hält { $failed } von { $count } Grenzwerten nicht ein.
certificate-fail-untested = NICHT BESTANDEN. { $failed } von { $tested } geprüften Grenzwerten sind nicht eingehalten; { $untested } weitere waren mit diesen Messungen nicht prüfbar: { $why }.
certificate-untested = UNVOLLSTÄNDIG. Die { $tested } geprüften Grenzwerte sind eingehalten; { $untested } weitere waren mit diesen Messungen nicht prüfbar: { $why }.
certificate-nothing-tested = UNVOLLSTÄNDIG. Keiner der { $count } Grenzwerte war mit diesen Messungen prüfbar: { $why }.
certificate-why-untested = es fehlt ein Versuch bei dieser Geschwindigkeit oder einer, der für Reibung und Gaskraft langsam genug ist
certificate-why-untested-at-setting = es fehlt ein Versuch bei dieser Geschwindigkeit und Einstellung, einer, der für Reibung und Gaskraft langsam genug ist, oder ein solcher Sprung der Einstellung
certificate-interpolated = { $tests }, interpoliert
certificate-model-passes = Das Modell kommt bei jedem Grenzwert zum selben Urteil.
certificate-model-fails = Das Modell kommt bei { $count } der Grenzwerte zu einem anderen Urteil als die Messung; eine Simulation zeigt dort also einen anderen Dämpfer.
certificate-caption = Kräfte gelten bei Spitzengeschwindigkeit, gemittelt über die Zyklen des Versuchs mit dem längsten Hub, der die Geschwindigkeit erreicht; zwischen zwei Versuchen, deren Geschwindigkeiten sich höchstens um den Faktor { $ratio } unterscheiden, wird linear interpoliert, sonst gilt ein Versuch innerhalb von { $percent } % der Geschwindigkeit. Zugstufe und Zugkraft zählen positiv, die Druckstufe negativ. Gaskraft und Reibung sind Mittel und halber Unterschied der Hübe langsamer Versuche. Hysterese ist der mittlere Abstand zwischen steigender und fallender Geschwindigkeit bei gleicher Geschwindigkeit.
subject-part = Teil: { $text }
subject-serial = Seriennummer: { $text }
subject-tester = Prüfer: { $text }
subject-rig = Prüfstand: { $text }
subject-measured = Gemessen am: { $text }
subject-temperature = Temperatur bei der Messung: { $low } bis { $high } °C
to-fill-in = ______________________________
col-limit = Grenzwert
col-at = bei, mm/s
col-low-limit = unten
col-high-limit = oben
col-verdict = Urteil
col-from = aus Versuch
pass = bestanden
fail = NICHT BESTANDEN
not-tested = NICHT GEPRÜFT
force-rebound = Kraft, Zugstufe
force-compression = Kraft, Druckstufe
gas-force = Gaskraft
friction = Reibung
hysteresis = Hysterese

## How it was made.

made-version = Geschrieben von dashpot { $version }.
made-date = Datum: { $date }.
made-command = Befehl: { $command }
made-again = Gleiche Version, gleicher Befehl und gleiche Dateien geben wieder die gleichen Zahlen. Die Prüfsumme ist SHA-256, wie sha256sum sie zeigt.
col-file = Datei
col-bytes = Bytes
made-all = Alle { $count } Dateien zusammen: SHA-256 { $hash } (der Zeilen, die sha256sum von ihnen in dieser Reihenfolge zeigt).
made-files = Gelesene Dateien.

## Manoeuvres.

manoeuvre-title = Fahrmanöver { $name }
manoeuvre-subtitle = Modell { $model } gegen seine FV-Kurve, Schritte von { $step } s
manoeuvre-answer = Mit dem Modell ist die größte Dämpferkraft { $force } N, mit der FV-Kurve allein { $curve } N, beide an { $corner }; die Kräfte dort unterscheiden sich um { $difference } N effektiv, { $share } % der effektiven Kraft.
manoeuvre-answer-same = Modell und FV-Kurve geben in diesem Manöver dieselben Kräfte.
manoeuvre-beyond = Der Dämpfer { $corner } bewegt sich mit { $saw } mm/s; seine FV-Kurve wurde bei { $ends } mm/s identifiziert und geht darüber hinaus geradlinig weiter, { $share } % der Zeit.
manoeuvre-quiet = In Schritten von { $host } ms rattert der Austausch von Kraft und Bewegung: er fügt der Kraft mit der FV-Kurve bis zu { $curve } N (Effektivwert) hinzu und der mit dem Modell { $model } N. Unterschiede von Kraft und Hub sind deshalb die in Schritten von { $quiet } ms; alles andere ist so, wie der Simulator es rechnet.
manoeuvre-chassis = Hubbeschleunigung des Aufbaus: größte { $peak } m/s² (FV-Kurve { $peak_curve }), effektiv { $rms } m/s² (FV-Kurve { $rms_curve }); der Hub unterscheidet sich um { $heave } mm effektiv.
corner-section = Dämpferkräfte
corner-force-velocity = { $corner }: Kraft über Geschwindigkeit
corner-force-time = { $corner }: Kraft über Zeit
corner-difference = { $corner }: Modell minus FV-Kurve
axis-difference = Modell − FV-Kurve, N
corners-table = Räder in Zahlen
corners-caption = Bewegung und Kraft jedes Dämpfers. L1 ist vorn links, R2 hinten rechts.
col-corner = Rad
group-largest-force = größte Kraft, N
group-energy-j = Energie, J
col-rms-difference = Unterschied effektiv, N
road-section = Straße und Geschwindigkeit
road-caption = Die Straße unter den Vorderrädern, links und rechts. Das Fahrzeug fährt { $speed } km/h.
plot-road = Straße unter den Vorderrädern
axis-road = Straßenhöhe, mm
chassis-section = Aufbau
plot-heave = Hub des Aufbaus
plot-heave-acceleration = Beschleunigung des Aufbaus
plot-roll = Wanken
plot-lateral = Querbeschleunigung
axis-heave = Hub, mm
axis-heave-acceleration = Hubbeschleunigung, m/s²
axis-roll = Wankwinkel, °
axis-lateral = Querbeschleunigung, m/s²
region-section = Arbeitsbereich
region-with-tests = Wo die Dämpfer arbeiteten, über den Schleifen der Prüfstandsversuche. Außerhalb davon ist das Modell nicht geprüft.
region-without-tests = Wo die Dämpfer arbeiteten. Mit --tests werden die Schleifen der Prüfstandsversuche darunter gezeichnet.
plot-region = { $corner }: Arbeitsbereich
in-vehicle = im Fahrzeug
rig-tests = Prüfstand
vehicle-section = Fahrzeug
vehicle-caption = Das simulierte Fahrzeug. Mit --vehicle car.toml kann jeder dieser Namen einen anderen Wert bekommen.
wheel-left = links
wheel-right = rechts
coupling-unstable = c h / m erreicht { $moving } am Rad von { $mass } kg (c: Steigung der Kraft über der Geschwindigkeit, h: Schritt): ein Simulator, der Kraft und Bewegung mit einem Schritt Verzug austauscht, ist über 1 instabil, ohne Verzug über 2; ein kürzerer Schritt hilft.
coupling-chatter = c h / m (c: Steigung der Kraft über der Geschwindigkeit, h: Schritt) ist am bewegten Rad von { $mass } kg höchstens { $moving }, aber { $all }, wo die Reibung umkehrt (unter { $slow } mm/s): dort rattert der Austausch innerhalb der Reibkraft; ein kürzerer Schritt oder weniger steile Reibung hilft.
col-near-tests = nahe Prüfstand, % der Zeit
saw-displacement = Weg, mm
saw-velocity = Geschwindigkeit, mm/s

## The workbook.

workbook-contents = Inhalt
workbook-sheet = Blatt
workbook-about = was es zeigt

## What a fit found.

fit-title = Ergebnis der Identifikation
fit-subtitle = Modell { $model } aus den Prüfstandsdaten in { $data }
fit-answer = An { $tests } Versuche angepasst, Abweichung { $error }.
quality-sentence = { $grade }: Das Modell verfehlt die gemessene Kraft im Mittel um { $error } N ({ $percent } % der größten Kraft), { $beside }; { $curve }.
quality-noise = So gut, wie es das Rauschen erlaubt
quality-good = Gute Anpassung
quality-fair = Mäßige Anpassung
quality-poor = Schlechte Anpassung
quality-beside-noise = das { $ratio }-Fache des Rauschens der Messungen ({ $noise } N)
quality-noise-unknown = das Rauschen dieser Messungen ist nicht bekannt
quality-curve-worse = die FV-Kurve allein verfehlt sie um { $error } N ({ $percent } %), { $ratio }-mal so viel
quality-curve-no-worse = die FV-Kurve allein ist nicht schlechter, { $error } N ({ $percent } %)
fit-measured = Fehler der Messung
fit-tests = Angepasste Versuche
remarks = Bemerkungen
col-why = warum
col-interval = 95-%-Intervall

## Of figures and tables everywhere.

comma = ,{ " " }
sentence-end = { $sentence }.
semicolon = ;{ " " }
colon = :{ " " }

## The direction that the files count positive.

sign-given = In den Dateien zählt die { $direction } positiv, wie angegeben.
sign-found = In den Dateien zählt die { $direction } positiv ({ $percent } % sicher).
sign-found-by = In den Dateien zählt die { $direction } positiv ({ $percent } % sicher): { $reasons }.
range = { $low } bis { $high }
before = vorher
after = nachher

## Figures before and after.

axis-residual = gemessen − berechnet, N
axis-residual-rms = Effektivwert gemessen − berechnet, N
axis-resistance = Widerstand gemessen − berechnet, N
axis-since-reversal = Zeit seit der Umkehr, ms
axis-error-rms = Fehler, N effektiv
plot-error-rms = Fehler jedes Versuchs, N effektiv
plot-left-velocity = Rest über Geschwindigkeit
plot-left-size = Größe des Rests über Geschwindigkeit
plot-left-up = Mittel des Rests, schneller werdend
plot-left-down = Mittel des Rests, langsamer werdend
plot-left-reversal = Mittel des Rests nach einer Umkehr
plot-left-map = Mittel des Rests über Geschwindigkeit und Weg
fitted-tests = angepasste Versuche
left-out = zurückgehalten
stretch = { $test } ({ $place } von { $count })

## Diagnosis: title and answer.

diagnosis-title = Wo Modell und Messung voneinander abweichen und was fehlt
errors-caption = Jede Spalte ist ein Versuch: wie weit die berechnete Kraft von der gemessenen entfernt ist, vorher (grau) und nachher (rot). Ein roter Punkt auf dem Strich heißt, dass nur Rauschen übrig ist. Zurückgehaltene Versuche hat keine Anpassung gesehen: was sich dort schließt, ist echt.
error-unseen = In den { $tests } Versuchen, die keine Anpassung gesehen hat, geht der Fehler von { $before } auf { $after } N effektiv
error-fitted = Kein Versuch wurde zurückgehalten (zu wenige oder keiner benannt); die Zahlen zeigen also, wie gut das Modell passt, nicht wie gut es vorhersagt: der Fehler geht von { $before } auf { $after } N effektiv
gap-is-closed = { $error }; { $gap } der Lücke zwischen Modell und Rauschen sind geschlossen, jeder Versuch gemessen an seinem eigenen Rauschen.
nothing-stays = Das Modell bleibt, wie es ist; nur seine Zahlen wurden neu angepasst.
changed-stays = Das Modell behält seine Form; seine Zahlen sind jetzt die dieses Dämpfers.
nothing-added-rivals = Es wurde nichts hinzugefügt: unter Namen zu raten, die die Messung gleich gut erklären, wäre wertlos. Die möglichen Ursachen stehen unten, ebenso die Versuche, die entscheiden würden.
nothing-added-unknown = Es wurde nichts hinzugefügt: die Abweichung ist unten ohne Namen beschrieben. Ihr Verlauf über Geschwindigkeit, Weg und Zeit zeigt, wonach am Dämpfer oder am Prüfstand zu suchen ist.
worse-tests = { $count } von { $all } zurückgehaltenen Versuchen weichen stärker ab als vorher, zum Beispiel { $test }.
row-before = vorher (das gegebene Modell, neu angepasst)
col-fitted-rms = angepasste Versuche, N effektiv
col-their-noise = deren Rauschen, N effektiv
col-left-out-rms = zurückgehaltene Versuche, N effektiv
mean-cycles-caption = An mittleren Zyklen, die weniger rauschen als einzelne. Fehler in Prozent: mittleres |berechnet − gemessen| eines Versuchs durch seine größte Kraft, Mittel über alle Versuche.
whole-deviation = im Mittel { $error } N ({ $percent } %)
whole-records = Über alle Abtastwerte aller Messungen, wie dashpot validate misst: { $came } mit dem gegebenen Modell, { $refitted } neu angepasst, { $improved } verbessert. Die Zahlen darüber gelten für mittlere Zyklen, in denen das Rauschen herausgemittelt ist.

## The picture of a diagnosis.

name-and-sure = { $name } ({ $sure } sicher)
picture-named = Es fehlt: { $names }
picture-nothing = Es fehlt nichts
picture-cannot-tell = Etwas fehlt, und diese Messungen können nicht sagen, was
picture-unknown = Etwas fehlt, das kein bekannter Effekt erklärt
picture-below = Oben: Versuch { $test }, { $kind }. Unten: alle Versuche.
kind-left-out = bei jeder Anpassung zurückgehalten
kind-fitted = angepasst

## Where they disagree.

where-section = Wo sie voneinander abweichen
no-region = Kein Bereich hebt sich vom Rauschen ab.
left-map-caption = Gemessene minus berechnete Kraft, gemittelt über alle Versuche, an jeder Stelle von Geschwindigkeit und Weg, die sie erreichen; beide Karten haben eine Farbskala. Ein Streifen längs der Geschwindigkeit null ist Reibung, ein Anstieg längs des Wegs eine Feder oder Gas, verschiedene Vorzeichen bei gleicher Geschwindigkeit ein Nacheilen. Beide Achsen geben dem Teil nahe null mehr Platz.
left-size-caption = Wie groß der Rest bei jeder Geschwindigkeit ist. Wo Rot auf der blassen Linie liegt, ist nur Rauschen übrig.
left-reversal-caption = Was auf eine Umkehr folgt: unter null baut der Dämpfer seine Kraft später auf als berechnet (Nachgiebigkeit, Spiel, Vorgleiten, verspäteter Kanal), über null ist sein Widerstand größer (Losbrechen).
speeding-up-caption = Dieselbe Geschwindigkeit, während der Hub schneller wird …
slowing-down-caption = … und während er langsamer wird. Wo sich beide unterscheiden, fehlt eine Hysterese oder ist eine zu groß.
all-there = alle, die dorthin kommen
rebound = Zugstufe
compression = Druckstufe
speeding-up = schneller werdend
slowing-down = langsamer werdend
both = beides
col-direction = Richtung
col-speed = Verlauf
col-mean-n = Mittel, N
col-rms-n = effektiv, N
col-noise-n = Rauschen, N
col-in-words = in Worten
regions-caption = Gemessene minus berechnete Kraft des gegebenen Modells (neu angepasst) über die angepassten Versuche: Bereiche, die sich vom Rauschen abheben, zuerst die aller Versuche, dann die schlechtesten.

## What is missing.

findings-section = Was fehlt
suspects-section = Mögliche Ursachen
suspects-cannot-tell = Eines davon fehlt, das Wahrscheinlichste zuerst.
suspects-beside = Was daneben noch fehlen könnte, das Wahrscheinlichste zuerst; nichts davon ist wahrscheinlich genug, um hinzugefügt zu werden.
suspects-nearest = Was am nächsten kommt; nichts davon ist wahrscheinlich genug, um benannt zu werden.
rig-added = Der Prüfstand hat der Messung hinzugefügt: { $all }. Das ist nur in diesem Vergleich berichtigt und nicht Teil des verbesserten Modells; den Prüfstand vor der nächsten Messreihe in Ordnung bringen.
changed-section = Zahlen, die anders sind als am Referenzdämpfer
inventory-section = Inventar
col-force-rms = Kraft, N effektiv
col-share-of-force = Anteil an der Kraft
col-status = Stand
status-kept = behalten
status-added = hinzugefügt
status-replaced = ersetzt
status-removed = entfernt
replaces = anstelle von { $effect }
or-instead = oder an seiner Stelle { $effect } ({ $probability })
inventory-caption = Alle Effekte des gegebenen und des wahrscheinlichsten Modells. Die Kraft eines Effekts ist das, was sich ohne ihn ändert, wenn alles andere bleibt.
other-effects = weitere Effekte
plot-inventory = Kraft jedes Effekts, N effektiv
axis-effect-force = Kraft, N effektiv
inventory-bands-caption = Effektivwert über die angepassten Versuche eines Bands, aneinandergereiht. Gegenphasige Kräfte heben sich teilweise auf, sodass ein Balken länger sein kann als ihre Summe.
shifts-section = Zahlen des Modells, die sich verschoben haben
finding-heading = { $place }. { $effect }{ $form }: { $sure } sicher
finding-form = { " " }({ $form })
finding-gap = { " " }Ohne ihn öffnen sich { $gap } der Lücke wieder.
finding-of-rig = Der Effekt gehört zum Prüfstand, nicht zum Dämpfer: im Vergleich berichtigt, nicht ins Modell übernommen.
finding-added = Der Effekt ist dem verbesserten Modell hinzugefügt.
finding-what = { $meaning }. { $added }{ $gap }
finding-why = Wo: { $path } (Familie: { $family }, { $family_sure } sicher). Warum: ohne den Effekt kommen { $share } der Abweichung zurück; in { $tests } der Versuche bleibt mit ihm weniger übrig.
rivals-caption = Was sonst an seiner Stelle versucht wurde.
col-parameter = Parameter
col-judged = Beurteilung
plausible = glaubhaft
not-plausible = außerhalb dessen, was Dämpfer und Prüfstände zeigen: mit Vorsicht behandeln
col-effect = Effekt
col-confidence = Sicherheit
col-explains = erklärt
col-reference = Referenz
col-this-damper = dieser Dämpfer
changed-caption = Die Änderungen sind nach der Kraft geordnet, die sie in den Versuchen bewirken.
col-change = Änderung
shifts-caption = Ohne den Effekt hatten diese Zahlen einen Teil von ihm aufgenommen. Gezeigt sind die, die sich um mehr als drei Standardabweichungen verschoben haben.

## Loops.

loops-section = Schleifen vorher und nachher
more-loops-section = Schleifen weiterer Versuche
loops-about = Die Versuche, deren Abweichung vorher den größten Anteil ihrer Kraft ausmacht. Blau ist der gemessene mittlere Zyklus, grau das an diese Versuche neu angepasste Modell, rot das verbesserte; das dritte Bild vergrößert, was von der Kraft übrig ist.
loop-heading = { $test }, { $kind }
loop-errors = Fehler vorher { $before } N effektiv, nachher { $after } N; Rauschen allein macht { $noise } N aus.{ $closed }
loop-closed = { " " }{ $gap } der Lücke sind geschlossen.

## Errors by amplitude and peak velocity, before and after.

map-before = Fehler vorher, % der größten Kraft
map-after = Fehler nachher, % der größten Kraft
map-before-caption = Ein Feld je Amplitude und Spitzengeschwindigkeit; dunkel heißt große Abweichung.
map-after-caption = Dasselbe mit dem, was gefunden wurde, in denselben Farben.
mean-cycles-rule = Jeder Versuch hat in seiner Zeile gleiches Gewicht; das Prozent bezieht sich auf die größte Kraft der Zeile. Fehler mittlerer Zyklen: das Rauschen ist kleiner als in dashpot validate, das jeden Abtastwert vergleicht.

## Everything that was tried.

tried-section = Alles, was versucht wurde
tried-about = In jedem Durchgang wird jede Form jedes Effekts dem Modell hinzugefügt, und alle Zahlen werden mit ihr neu angepasst, von mehreren Startwerten aus. Was benannt wurde, ist in diesem Modell: seine Zeilen stehen zuerst und vergleichen das Modell mit und ohne es. Erklärt: Anteil am mittleren Quadrat jenseits des Rauschens. Restfehler: Mittel über die Versuche, in Einheiten dessen, was Rauschen und Form der Kurven übrig lassen. Log-Chance: um wie viel wahrscheinlicher die Messung damit ist, als natürlicher Logarithmus; jeder Versuch zählt als eine unabhängige Stichprobe, und der Preis der zusätzlichen Zahlen ist abgezogen. Ungewöhnliche Werte: der Abzug für Werte, die Dämpfer kaum zeigen, in derselben Einheit. Die Wahrscheinlichkeit ist die des Effekts über alle seine Formen.
col-form = Form
col-probability = Wahrscheinlichkeit
col-error-left = Restfehler
col-log-odds = Log-Chance
col-strange = ungewöhnliche Werte
col-tests-better = Versuche besser
look = Durchgang { $number }.

## What to measure next.

limits-section = Was als Nächstes zu messen ist
next-tests-section = Versuche, die sich als Nächstes lohnen
cannot-show-section = Was diese Messungen nicht zeigen können
all-would-show = Jeder bekannte Effekt hätte sich in diesen Messungen gezeigt.
col-cannot-show = warum, und welcher Versuch es zeigen würde
cannot-show-caption = Weder gefunden noch ausgeschlossen.
col-next-amplitude = Amplitude, mm
col-next-frequency = Frequenz, Hz
col-next-mean = Mittellage, mm
col-side-force = Seitenkraft, N
col-difference-rms = Unterschied, N effektiv
col-what-to-do = was zu tun ist
next-tests-caption = Unterschied: um wie viel die Vorhersagen der Erklärungen dort auseinanderliegen. Ein Versuch entscheidet, wo das deutlich über dem Rauschen liegt.

## Parameters of the improved model.

source-refitted = neu angepasst
source-added = hinzugefügt: { $effect }

## Many dampers.

groups-title = Was sich zwischen Dämpfern geändert hat
groups-subtitle = Modell { $model } gegen jede Gruppe; Referenz: { $reference }
groups-section = Was sich in welcher Gruppe geändert hat
groups-caption = Jede Gruppe neben der Referenz. N effektiv über die mittleren Zyklen der Versuche, das Modell neu angepasst: bevor ein Name hinzukommt, danach, und was allein das Rauschen ausmacht.
group-against = { $group }, gegen { $reference }
col-group = Gruppe
col-answer = Ergebnis
col-named = benannt
col-before-n = vorher, N
col-after-n = nachher, N
col-group-noise = Rauschen, N
no-change = keine Änderung über die Intervalle hinaus
not-compared = nicht verglichen: diese Messungen zeigen es nicht
other-groups = weitere Gruppen
plot-group-curves = FV-Kurven aller Gruppen
group-curves-caption = Kraft jedes Dämpfers bei gleichförmiger Bewegung, mit Reibung und Gas, so weit seine Versuche reichen; gestrichelt: die Referenz.
numbers-section = Zahlen, die sich geändert haben
numbers-caption = Zahlen des Modells, die sich in mindestens einer Gruppe stärker von der Referenz unterscheiden, als beide offenlassen.
col-quantity = Größe
measurement-section = Die Messung selbst
aside-section = Beiseitegelassen
aside = Versuche, die zu keiner Gruppe gehören: { $tests }.
without-test = Zeilen der Gruppenliste, zu denen es in den Daten nichts gibt: { $tests }.

# Names of effects, elements and parameters are short, and without commas, since they stand in lists.

## Names. Effects and elements.

name-fv-curve = FV-Kurve
name-gas-preload = konstante Gaskraft
name-gas-spring = Gasfeder
name-coulomb-friction = Trockenreibung
name-stribeck-friction = Reibung mit Losbrechkraft
name-presliding-friction = Reibung mit Vorgleiten
name-viscous-friction = viskose Reibung
name-side-force-friction = Reibung durch Seitenkraft
name-series-compliance = Reihennachgiebigkeit
name-bushing = Gummilager
name-parallel-spring = Parallelfeder
name-oil-compressibility = Nachgiebigkeit des Öls
name-aeration = Luft im Öl
name-cavitation = Kavitation
name-gas-warming = Gaskraft über der Temperatur
name-temperature-fade = Nachlassen mit der Temperatur
name-position-dependent-damping = hubabhängige Dämpfung
name-bump-stop = Druckanschlag
name-rebound-stop = Zuganschlag
name-free-play = Spiel
name-frequency-selective-damping = frequenzselektive Dämpfung
name-valve-hysteresis = Ventilhysterese
name-moving-mass = bewegte Masse
name-lagged-polynomial = Polynom mit Verzögerung
name-integration = Integration
name-cylinder-expansion = Zylinderaufweitung

## Names. Effects of the rig, and what looks like something that has no name.

name-channel-delay = Verzug des Kraftkanals
name-force-offset = Nullpunktfehler der Kraftmessdose
name-force-drift = Nullpunktdrift der Kraftmessdose
name-gain-drift = Verstärkungsdrift des Kraftkanals
name-load-dependent-friction = lastabhängige Reibung
name-load-cell-hysteresis = Hysterese der Kraftmessdose
name-resonance = Resonanz

## Names. Their numbers.

name-delay = Verzug
name-rig-mass = Masse an der Kraftmessdose
name-offset = Nullpunktfehler
name-drift = Drift
name-whole-drift = Drift insgesamt
name-share = Anteil
name-share-across = Anteil in Querphase
name-share-growth = Zunahme des Anteils
name-cooling-rate = Abkühlrate

## Names. Parts of the FV curve that change as one.

name-rebound-curve = Kraft der Zugstufe
name-compression-curve = Kraft der Druckstufe
name-rebound-low-speed = Zugstufe bei kleiner Geschwindigkeit
name-compression-low-speed = Druckstufe bei kleiner Geschwindigkeit
name-rebound-high-speed = Zugstufe bei hoher Geschwindigkeit
name-compression-high-speed = Druckstufe bei hoher Geschwindigkeit

## Names. The FV curve.

name-fv-form = Form der FV-Kurve
name-fv-interpolation = Interpolation der FV-Kurve
name-fv-velocity = Geschwindigkeit der FV-Kurve
name-fv-force = Kraft der FV-Kurve
name-fv-rebound-c1 = erste Steigung der Zugstufe
name-fv-rebound-c2 = zweite Steigung der Zugstufe
name-fv-rebound-c3 = dritte Steigung der Zugstufe
name-fv-rebound-v1 = erster Knick der Zugstufe
name-fv-rebound-v2 = zweiter Knick der Zugstufe
name-fv-compression-c1 = erste Steigung der Druckstufe
name-fv-compression-c2 = zweite Steigung der Druckstufe
name-fv-compression-v1 = Knick der Druckstufe

## Names. In series.

name-series-stiffness = Reihensteifigkeit
name-series-damping = Reihendämpfung
name-internal-mass = innere Masse
name-series-load = Last der Reihenfeder
name-free-play-gap = Größe des Spiels
name-free-play-load = Last auf dem Spiel
name-free-play-force = Weichheit der Anlage
name-bushing-hardening = Verhärtung des Gummis
name-bushing-loss-stiffness = dynamische Versteifung des Gummis
name-bushing-loss-time = Relaxationszeit des Gummis
name-bushing-slip = Gleitweg des Gummis
name-bushing-stop = Gummiweg bis zum Anschlag
name-bushing-stop-stiffness = Steifigkeit des Gummianschlags
name-bushing-slow-stiffness = langsame Versteifung des Gummis
name-bushing-slow-time = langsame Relaxationszeit des Gummis

## Names. Oil.

name-oil-stiffness = Steifigkeit der Ölsäule
name-oil-shortening = Verkürzung der Ölsäule
name-oil-chambers = nachgiebige Kammern
name-oil-compression = Verhältnis der Ölsteifigkeiten
name-aeration-stroke = Luftweg
name-aeration-force = Kraft zum Schließen der Luft
name-aeration-compression = Luftverhältnis der Druckstufe
name-cavitation-force = Kavitationsgrenze
name-cavitation-side = kavitierende Richtung
name-cavitation-return = Kraft auf dem Rückweg
name-cavitation-form = Form der Kavitation
name-cavitation-velocity = Grenzgeschwindigkeit des Bodenventils
name-cavitation-unfilled = nicht nachgefüllter Anteil
name-lost-stroke = Totgang
name-cavitation-onset = Beginn der Kavitation
name-cavitation-expansion = Aufweitung des Hohlraums

## Names. Over the stroke.

name-bypass-share = fehlender Anteil in der Zone
name-bypass-centre = Mitte der Zone
name-bypass-half-width = halbe Breite der Zone
name-bypass-blend = Übergang der Zone
name-bypass-strokes = Richtungen der Zone
name-bypass-form = Form der Zone
name-bypass-flow = Strom durch die Nut

## Names. Heat.

name-fade-source = Herkunft der Temperatur
name-fade-coefficient = Abfall je Kelvin
name-fade-reference = Bezugstemperatur
name-heat-capacity = Wärmekapazität
name-heat-transfer = Wärmeabgabe je Kelvin
name-fade-laminar-force = Grenzkraft laminarer Strömung
name-fade-slackening = Abflachen des Abfalls

## Names. Valves.

name-fsd-form = Form der Frequenzabhängigkeit
name-fsd-share = Verlust bei schnellen Hüben
name-fsd-time = Zeitkonstante der Frequenzabhängigkeit
name-fsd-velocity = Füllgeschwindigkeit der Steuerkammer
name-fsd-flow = Bypass-Strom
name-fsd-force = Füllkraft der Steuerkammer
name-fsd-laminar-force = Laminargrenze des Bypasses
name-valve-hysteresis-share = Anteil der Ventilhysterese
name-valve-opening-force = Öffnungskraft des Ventils
name-valve-closing-ratio = Verhältnis Schließ- zu Öffnungskraft
name-valve-time = Stellzeit des Ventils
name-valve-width = Öffnungsbereich des Ventils
name-valve-form = Form der Ventilhysterese
name-valve-play = Spiel des Ventils
name-valve-damping = Dämpfungsmaß des Ventils

## Names. Springs.

name-spring-linear = lineare Federrate
name-spring-quadratic = quadratische Federrate
name-spring-cubic = kubische Federrate
name-spring-quartic = Federrate vierten Grades
name-spring-displacement = Weg der Federtabelle
name-spring-force = Kraft der Federtabelle

## Names. Friction.

name-coulomb-force = Reibkraft
name-coulomb-steepness = Steilheit der Reibung
name-stribeck-form = Stribeck-Form
name-stribeck-breakaway-force = Losbrechkraft
name-stribeck-coulomb-force = Reibkraft nach dem Losbrechen
name-stribeck-breakaway-velocity = Losbrechgeschwindigkeit
name-stribeck-velocity = Stribeck-Geschwindigkeit
name-stribeck-fall = Exponent des Abfalls
name-stribeck-rise = Höhe der Spitze
name-stribeck-rise-power = Exponent des Anstiegs
name-viscous-coefficient = viskoser Beiwert
name-side-force-coefficient = Reibung je Seitenkraft
name-side-force-steepness = Steilheit der Seitenkraftreibung
name-presliding-force = Reibkraft bei Vorgleiten
name-presliding-length = Vorgleitweg
name-presliding-power = Form des Vorgleitens
name-presliding-return = Rückgang nach der Umkehr
name-presliding-creep = Kriechgeschwindigkeit

## Names. Gas.

name-gas-force = Gaskraft
name-gas-warming-rate = Zuwachs der Gaskraft je Kelvin
name-gas-warming-reference = Bezugstemperatur der Gaskraft
name-gas-stiffness = Gassteifigkeit
name-gas-length = Länge der Gassäule
name-gas-adiabatic-index = Adiabatenexponent
name-gas-thermal-time = Wärmezeit des Gases

## Names. The model of the literature.

name-polynomial = Koeffizienten des Polynoms
name-lag-slow = Verzögerung bei kleiner Geschwindigkeit
name-lag-fast = Verzögerung bei großer Geschwindigkeit
name-lag-v1 = untere Geschwindigkeit der Verzögerung
name-lag-v2 = obere Geschwindigkeit der Verzögerung

## Names. Masses and stops.

name-moving-mass-time = Nacheilen der bewegten Masse
name-moving-mass-place = Ort der bewegten Masse
name-bump-stop-clearance = Weg bis zum Druckanschlag
name-bump-stop-stiffness = Steifigkeit des Druckanschlags
name-bump-stop-progression = Progression des Druckanschlags
name-bump-stop-loss = Verlust des Druckanschlags
name-bump-stop-damping = Dämpfung des Druckanschlags
name-bump-stop-flow = Strömung des Druckanschlags
name-rebound-stop-clearance = Weg bis zum Zuganschlag
name-rebound-stop-stiffness = Steifigkeit des Zuganschlags
name-rebound-stop-progression = Progression des Zuganschlags
name-rebound-stop-loss = Verlust des Zuganschlags
name-rebound-stop-damping = Dämpfung des Zuganschlags
name-rebound-stop-flow = Strömung des Zuganschlags

## Names. The step.

name-method = Integrationsverfahren
name-substeps = Teilschritte

## Choices of a parameter: they stand in a list of a narrow panel.

choice-automatic = automatisch
choice-both = beide
choice-bypass = Umgehung
choice-cap = begrenzte Kraft
choice-compression = Druckstufe
choice-cubic-each-side = kubisch je Seite
choice-driven-end = bewegtes Ende
choice-elastic = elastisch zurück
choice-euler = Euler
choice-factor = Faktor
choice-filter = Filter
choice-foot-valve = Bodenventil
choice-fourth-order = vierte Ordnung
choice-full = vollständig
choice-gap = Spalt
choice-groove = Nut
choice-hydraulic = hydraulische Kraft
choice-inside = innen
choice-linear = linear
choice-measured = gemessen
choice-monotone-cubic = monoton kubisch
choice-opening = Öffnung
choice-orifice = Blende
choice-piecewise = gerade Stücke
choice-play = Reibung des Schiebers
choice-rebound = Zugstufe
choice-second-order = zweite Ordnung
choice-self-heating = Eigenerwärmung
choice-simplified = vereinfacht
choice-slips = gleitet sofort
choice-spool = Masse des Schiebers
choice-stroke = in jedem Hub
choice-table = Tabelle
choice-third-order = dritte Ordnung
choice-three-stage = drei Stufen
choice-whole = gesamte Kraft

## What elements and effects are. Names of forms such as `bypass` stand in model files and are not translated.

element-fv-curve = Grunddämpfer: die Kraft-Geschwindigkeits-Kurve (FV-Kurve)
element-series-compliance = Feder und Dämpfer in Reihe mit der inneren Masse (Nachgiebigkeit von Gas, Öl und Lager)
element-free-play = Spiel in einem Auge oder Lager; braucht series_compliance
element-bushing = Gummi in Reihe mit dem Dämpfer: die Reihenfeder wird härter und verliert Energie; braucht series_compliance
element-oil-compressibility = Nachgiebigkeit der Ölsäule (mit der Aufweitung des Zylinders) vor den Ventilen
element-aeration = Luft im Öl: die Ölsäule ist weich, solange die Kraft klein ist
element-cavitation = Kavitation: die hydraulische Kraft einer Richtung ist begrenzt, und ein Hohlraum muss erst wieder geschlossen werden
element-position-dependent-damping = Dämpfung, die über einen Teil des Hubs schwächer (Bypass) oder straffer ist
element-temperature-fade = Dämpfung, die mit der Temperatur des Öls fällt, gemessen oder durch die eigene Wärme
element-frequency-selective-damping = Dämpfung, die in schnellen Hüben schwächer ist als in langsamen gleicher Geschwindigkeit
element-valve-hysteresis = Überdruckventil, das spät öffnet und spät schließt: mehr Kraft bei steigender Geschwindigkeit
element-parallel-spring = Feder parallel zum Grunddämpfer: linear, quadratisch, kubisch, vierten Grades oder als Tabelle
element-coulomb-friction = Trockenreibung konstanter Höhe, F_s tanh(K v)
element-stribeck-friction = Trockenreibung mit Losbrechspitze
element-viscous-friction = viskose Reibung, F_v v|v|
element-side-force-friction = Trockenreibung proportional zur Seitenkraft
element-gas-preload = konstante Gaskraft
element-gas-warming = Gaskraft, die mit der Temperatur des Dämpfers wächst
element-lagged-polynomial = FV-Kurve als Polynom mit Verzögerung erster Ordnung, deren Zeitkonstante mit der Geschwindigkeit übergeht
element-presliding-friction = Reibung, die nach jeder Umkehr innerhalb eines kurzen Wegs umschlägt (Dahl)
element-gas-spring = Zunahme der Gaskraft mit dem Weg der Stange, langsam bis schnell
element-moving-mass = vom bewegten Ende zwischen Kraftmessdose und Dämpfer oder vom Kolben bewegte Masse
element-bump-stop = Anschlag am Ende der Druckstufe, Gummi oder hydraulisch
element-rebound-stop = Anschlag am Ende der Zugstufe, Gummi oder hydraulisch
element-integration = Einstellungen der Integration mit fester Schrittweite
element-channel-delay = der Kraftkanal kommt später als die Kanäle der Bewegung (Prüfstand)
element-force-offset = die Kraftmessdose zeigt ohne Last nicht null (Prüfstand)
element-force-drift = der Nullpunkt der Kraftmessdose wandert mit der Zeit (Prüfstand)

## What parameters mean.

parameter-fv-form = FV-Kurve aus der Tabelle oder aus Steigungen und Knicken
parameter-fv-interpolation = Verlauf der FV-Tabelle zwischen ihren Punkten
parameter-fv-velocity = Geschwindigkeiten der FV-Tabelle, Zugstufe positiv, steigend
parameter-fv-force = Kräfte der FV-Tabelle, Zugkraft positiv, nicht fallend
parameter-fv-rebound-c1 = Cr1: Steigung der Zugstufe unter dem ersten Knick
parameter-fv-rebound-c2 = Cr2: Steigung der Zugstufe zwischen den Knicken
parameter-fv-rebound-c3 = Cr3: Steigung der Zugstufe über dem zweiten Knick
parameter-fv-rebound-v1 = erster Knick der Zugstufe
parameter-fv-rebound-v2 = zweiter Knick der Zugstufe
parameter-fv-compression-c1 = Cc1: Steigung der Druckstufe unter dem Knick
parameter-fv-compression-c2 = Cc2: Steigung der Druckstufe über dem Knick
parameter-fv-compression-v1 = Knick der Druckstufe, als Geschwindigkeitsbetrag
parameter-series-stiffness = Steifigkeit der Reihenfeder, k_s
parameter-series-damping = Dämpfung neben der Reihenfeder, c_s
parameter-internal-mass = bewegte Masse von Stange, Öl und Gas, m
parameter-series-load = was die Reihenfeder trägt: die hydraulische Kraft und die Federn an der Masse, oder auch Reibung und Gaskraft, wie ein Auge oder Lager
parameter-free-play-gap = freier Weg von Anlage zu Anlage, 2 g
parameter-free-play-force = Kraft, bei der das Spiel halb geschlossen ist, F_0: Weichheit der Anlage
parameter-free-play-load = Kraft in der Mitte des Spiels, F_1: Gewicht am Auge, Gaskraft, die es trägt, Verspannung
parameter-bushing-hardening = Einfederung, bei der die Reihenfeder die doppelte Kraft hat, d_h
parameter-bushing-loss-stiffness = Anteil der Reihensteifigkeit, den schnelle oder kleine Bewegung hinzufügt, k_1/k_s
parameter-bushing-loss-time = Zeit, in der dieser Anteil nachgibt, tau
parameter-bushing-slip = Einfederung, in der dieser Anteil durch Reibung nachgibt, d_f; groß: allein durch Zeit
parameter-bushing-stop = Einfederung, bei der der Gummi nach jeder Seite einen Anschlag trifft, L
parameter-bushing-stop-stiffness = Anteil der Reihensteifigkeit, den der Anschlag hinzufügt, k_e/k_s; 0: kein Anschlag
parameter-bushing-slow-stiffness = Anteil der Reihensteifigkeit, der langsam nachgibt, k_2/k_s
parameter-bushing-slow-time = Zeit, in der dieser Anteil nachgibt, tau_2
parameter-oil-stiffness = Steifigkeit der Ölsäule bei x = 0, Aufweitung des Zylinders eingeschlossen, k_o
parameter-oil-shortening = Kehrwert der Länge der Säule bei x = 0, lambda; 0: überall gleiche Steifigkeit
parameter-oil-chambers = welche Säule nachgibt: die der Zugkammer oder die der Kammer unter Druck
parameter-oil-compression = Steifigkeit der Säule in der Druckstufe, als Anteil der in der Zugstufe, r_o
parameter-aeration-stroke = Weg, den die Luft in der Zugstufe aufnimmt, d_a
parameter-aeration-force = Kraft, bei der die Hälfte dieses Wegs aufgenommen ist, F_a
parameter-aeration-compression = Weg, den die Luft in der Druckstufe aufnimmt, als Anteil des Wegs in der Zugstufe, r_a
parameter-cavitation-force = größte hydraulische Kraft dieser Richtung, C
parameter-cavitation-side = Richtung, deren Kraft begrenzt ist
parameter-cavitation-return = Anteil der Grenzkraft, der auf dem Rückweg bleibt, während der Hohlraum sich schließt: 1 Gas drückt weiter, 0 Leerweg
parameter-cavitation-form = Hohlraum durch die begrenzte Kraft dieser Richtung oder durch ein Bodenventil, das die Kammer dahinter nicht nachfüllt
parameter-cavitation-velocity = Bodenventil: Geschwindigkeit dieser Richtung, über der die Kammer nicht nachgefüllt wird, v_f
parameter-cavitation-unfilled = Bodenventil: Anteil des Stroms über dieser Geschwindigkeit, der fehlt, a
parameter-cavitation-onset = Grenzkraft: Anteil davon, bei dem der Hohlraum sich öffnet, alpha; 1: bei der Grenzkraft selbst
parameter-cavitation-expansion = Grenzkraft: Hohlraum, über den die Hälfte des Rests gewonnen wird, während sein Gas sich ausdehnt, e_1
parameter-bypass-share = Anteil der FV-Kraft, der in der Zone fehlt, a; negativ: eine straffere Zone
parameter-bypass-centre = Weg in der Mitte der Zone, c
parameter-bypass-half-width = halbe Länge der Zone, w
parameter-bypass-blend = Länge, über die die Zone ausläuft, b
parameter-bypass-strokes = Richtungen, in denen es wirkt
parameter-bypass-form = Faktor auf die FV-Kraft oder Strom neben den Ventilen
parameter-bypass-flow = Nut: Kolbengeschwindigkeit, die in der Zone bei einer hydraulischen Kraft von 1 kN vorbeiströmt, q_b
parameter-fade-source = Temperatur wie gegeben, oder die der Umgebung und der Anstieg durch die eigene Wärme des Dämpfers
parameter-fade-coefficient = Abfall der Dämpfung je Kelvin, alpha
parameter-fade-reference = Temperatur der FV-Kurve, T_0
parameter-heat-capacity = Wärmekapazität von Öl und Gehäuse, C_h
parameter-heat-transfer = je Kelvin an die Umgebung abgegebene Wärme, h
parameter-fade-laminar-force = Kraft, bei der die Hälfte davon noch laminar ist und nachlässt, F_l; groß: alles lässt nach
parameter-fade-slackening = wie bald der Abfall je Kelvin kleiner wird, kappa; 0: exponentiell, 1/(T_0 + 95 degC): Gesetz von Vogel
parameter-fsd-form = nacheilender Anteil, Anteil, der in jedem Hub wiederkehrt, oder Strom neben den Ventilen, der in jedem Hub endet
parameter-fsd-share = Anteil der Kraft, den schnelle Hübe verlieren, a
parameter-fsd-time = Zeit, die schnell von langsam scheidet, tau
parameter-fsd-velocity = Form „stroke“: Geschwindigkeit, die die Steuerkammer füllt, u_0
parameter-fsd-flow = Form „bypass“: Kolbengeschwindigkeit, die bei einer hydraulischen Kraft von 1 kN vorbeiströmt, q_s
parameter-fsd-force = Form „bypass“: hydraulische Kraft, über der die Steuerkammer sich mit voller Rate füllt, F_0
parameter-fsd-laminar-force = Form „bypass“: hydraulische Kraft, unter der ihre Strömung laminar ist, F_l
parameter-valve-hysteresis-share = Form „opening“: Anteil der Kraft, den die Verspätung hinzufügt, eta
parameter-valve-opening-force = Kraft, bei der das Ventil öffnet
parameter-valve-closing-ratio = Form „opening“: Kraft, bei der es schließt, über der, bei der es öffnet; 1: allein die Zeit macht es spät
parameter-valve-time = Zeit, in der es sich bewegt, tau; Schieber: die seiner Schwingung durch 2 pi
parameter-valve-width = Kraft, über die es öffnet, b
parameter-valve-form = eine Öffnung, die spät kommt und geht, oder ein Ventil, das bei jeder Öffnung durch Reibung oder seine Masse nacheilt
parameter-valve-play = Form „play“: Kraft, der das Ventil nicht folgt, P
parameter-valve-damping = Form „spool“: Dämpfungsmaß, zeta
parameter-spring-linear = k_p in k_p x
parameter-spring-quadratic = k_p in k_p x|x|
parameter-spring-cubic = k_p in k_p x^3
parameter-spring-quartic = k_p in k_p x^3|x|
parameter-spring-displacement = Wege der Tabellenfeder, steigend; leer: keine Tabelle
parameter-spring-force = Kräfte der Tabellenfeder, nicht fallend
parameter-coulomb-force = Höhe der Reibung, F_s
parameter-coulomb-steepness = Steilheit des Vorzeichenwechsels, K
parameter-stribeck-form = welche der beiden Stribeck-Formen
parameter-stribeck-breakaway-force = Spitzenkraft (Übergangskraft), F_brk oder F_t
parameter-stribeck-coulomb-force = Höhe nach der Spitze, F_c oder F_s
parameter-stribeck-breakaway-velocity = Geschwindigkeit der Spitze, v_brk oder V_fs
parameter-stribeck-velocity = volle Form: Geschwindigkeitsmaß des Abfalls, V_s
parameter-stribeck-fall = volle Form: Exponent des Abfalls, a (1 Tustin, 2 Gauß)
parameter-stribeck-rise = volle Form: wie nahe die Spitze an F_t kommt, c
parameter-stribeck-rise-power = volle Form: Exponent des Anstiegs, d
parameter-viscous-coefficient = F_v in F_v v|v|
parameter-side-force-coefficient = Reibung je Seitenkraft, k_avg
parameter-side-force-steepness = Steilheit des Vorzeichenwechsels, K
parameter-gas-force = Gaskraft, positiv, wo sie die Stange hinausdrückt
parameter-gas-warming-rate = Zuwachs der Gaskraft je Kelvin, c
parameter-gas-warming-reference = Temperatur, bei der die Gaskraft die der anderen Elemente ist, T_0
parameter-polynomial = Koeffizienten von v^0, v^1, ...
parameter-lag-slow = Zeitkonstante bei kleiner Geschwindigkeit
parameter-lag-fast = Zeitkonstante bei großer Geschwindigkeit
parameter-lag-v1 = Geschwindigkeit, ab der die Zeitkonstante sich ändert
parameter-lag-v2 = Geschwindigkeit, bei der sie sich geändert hat
parameter-presliding-force = Höhe der Reibung nach langem Weg, F_c
parameter-presliding-length = Weg, auf dem die Kraft sich ihrer Höhe um den Faktor e nähert, z_0
parameter-presliding-power = 1: gleitet von Anfang an (Dahl); größer: biegt sich elastisch, bevor sie gleitet, n
parameter-presliding-return = nach einer Umkehr gleitet ein gebogener Kontakt sofort oder federt zuerst zurück
parameter-presliding-creep = Geschwindigkeit, unter der der Kontakt kriecht, v_c
parameter-gas-stiffness = langsame (isotherme) Steifigkeit bei x = 0, k
parameter-gas-length = Gasvolumen bei x = 0 durch die Fläche der Stange, L: wie bald es steifer wird
parameter-gas-adiabatic-index = Verhältnis von schneller zu langsamer Steifigkeit, gamma
parameter-gas-thermal-time = Zeit, in der das Gas die Temperatur seiner Wand annimmt, tau
parameter-moving-mass = Masse, M
parameter-moving-mass-time = Zeit, um die ihre Kraft nacheilt, tau; kurz gegen die Bewegung
parameter-moving-mass-place = was sie bewegt: das angetriebene Ende oder der Kolben hinter der Reihensteifigkeit
parameter-bump-stop-clearance = Einfederung von x = 0 aus, bei der der Anschlag getroffen wird, als positive Länge
parameter-bump-stop-stiffness = Steifigkeit beim ersten Kontakt
parameter-bump-stop-progression = Tiefe, in der die Feder die doppelte Kraft einer geraden hat
parameter-bump-stop-loss = Anteil der Federkraft, der auf dem Weg hinein und wieder hinaus verloren geht
parameter-bump-stop-damping = hydraulische Dämpfung auf dem Weg hinein, in der Tiefe der Progression
parameter-bump-stop-flow = hydraulische Kraft mit der Geschwindigkeit oder ihrem Quadrat (bei 1 m/s gleich)
parameter-rebound-stop-clearance = Ausfederung von x = 0 aus, bei der der Anschlag getroffen wird
parameter-rebound-stop-stiffness = Steifigkeit beim ersten Kontakt
parameter-rebound-stop-progression = Tiefe, in der die Feder die doppelte Kraft einer geraden hat
parameter-rebound-stop-loss = Anteil der Federkraft, der auf dem Weg hinein und wieder hinaus verloren geht
parameter-rebound-stop-damping = hydraulische Dämpfung auf dem Weg hinein, in der Tiefe der Progression
parameter-rebound-stop-flow = hydraulische Kraft mit der Geschwindigkeit oder ihrem Quadrat (bei 1 m/s gleich)
parameter-method = Verfahren innerhalb eines Schritts; automatic: das billigste, das den Fehler eines Schritts von 1 ms unter einem Tausendstel hält
parameter-substeps = Teilschritte innerhalb eines Schritts des Programms; 0: so viele, wie Steifigkeit und Dämpfung des Modells verlangen
