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
over-tests = Über { $tests ->
        [one] einen Versuch
       *[other] { $tests } Versuche
    }
headline = { $over } weicht das Modell im Mittel um { $error } N von der gemessenen Kraft ab, das sind { $percent } % der größten Kraft eines Versuchs. Die Kraft-Geschwindigkeits-Kurve allein weicht um { $curve_error } N ab, das sind { $curve_percent } %: { $verdict }{ $closer }.
verdict-exact = das Modell folgt der Messung genau
verdict-smaller = der mittlere Fehler des Modells ist um den Faktor { $ratio } kleiner
verdict-same = das Modell ist nicht nennenswert besser als die Kurve
verdict-larger = der mittlere Fehler des Modells ist um den Faktor { $ratio } größer: es ist schlechter als die Kurve
closer-in = , und es liegt in { $closer } von { $tests ->
        [one] { $tests } Versuch
       *[other] { $tests } Versuchen
    } näher an der Messung
left-out-figures = { $error } N oder { $percent } % (Kurve allein { $curve_error } N oder { $curve_percent } %)
left-out-sentence = { $left ->
        [one] In dem Versuch, den
       *[other] In den { $left } Versuchen, die
    } die Identifikation nicht gesehen hat, beträgt der mittlere Fehler { $left_figures }; in den { $fitted }, an die angepasst wurde, { $fitted_figures }.
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
matrix-about = Eine Zeile ist in Prozent der größten Kraft aller ihrer Versuche, auch derer bei anderer Einstellung. Eine Zelle ist das Mittel ihrer Versuche, jeder in Prozent seiner eigenen größten Kraft, wie im Bild der Versuche. Eine Zeile mit schwachen Versuchen kann daher unter ihren Zellen liegen.
key-section = Fehler in Zahlen
tests-section = Fehler jedes Versuchs
single-section = Einzelne Versuche
single-about = Nach Fehler geordnet, der schlechteste zuerst. Schleifen zeigen { $cycles ->
        [one] den letzten ganzen Zyklus
       *[other] die letzten { $cycles } ganzen Zyklen
    }; ein Versuch ohne ganze Zyklen wird ganz gezeigt. Fehler sind berechnet minus gemessen. Der Abstand der Hysterese ist über alle ganzen Zyklen gemittelt.
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
motion-periodic = { $amplitude } mm Amplitude bei { $frequency } Hz, Spitzengeschwindigkeit { $velocity } mm/s, { $cycles ->
        [one] { $cycles } ganzer Zyklus
       *[other] { $cycles } ganze Zyklen
    }.
motion-other = Nicht periodisch, Spitzengeschwindigkeit { $velocity } mm/s.
temperature = Temperatur { $first } °C am Anfang, { $last } °C am Ende.
force-noise = Rauschen der Kraft { $noise } N effektiv.
test-used = Zur Anpassung verwendet.
test-left-out = Nicht zur Anpassung verwendet.
test-sentence = Größte Kraft { $force } N. Mittlerer Fehler des Modells { $error } N, { $percent } %; der Kraft-Geschwindigkeits-Kurve allein { $curve_error } N, { $curve_percent } %.

## The literature.

family-section = Über der Einstellung
family-between = Zur Probe weggelassen, wird { $at } von einer Familie, die es nicht gesehen hat, mit einem Fehler von { $error } N ({ $percent } %) vorhergesagt, { $ratio } mal dem einer Anpassung an { $at } allein.
family-between-worse = Zwischen seinen Einstellungen ist das Modell unsicher. Zur Probe weggelassen, wird { $at } von einer Familie, die es nicht gesehen hat, mit einem Fehler von { $error } N ({ $percent } %) vorhergesagt, { $ratio } mal dem einer Anpassung an { $at } allein. Das Modell selbst enthält { $at }. { $advice }
family-between-records = Messungen zwischen { $at } und den Nachbarn helfen am meisten.
family-between-labels = Zuerst die bezweifelten Einstellungen der Versuche prüfen.
family-between-unknown = Keine Einstellung konnte weggelassen werden; der Fehler zwischen den Einstellungen ist daher unbekannt. Eine dritte Einstellung würde ihn zeigen.
family-about = Der Dämpfer hängt von einer Einstellung ab. In jedem Versuch ist es die des Versuchs; zwischen den Einstellungen der Modelldatei wird interpoliert.
family-interpolated = { $setting } (interpoliert)
plot-family = Kraft bei konstanter Geschwindigkeit, nach Einstellung
family-caption = Eine Kurve für jede Einstellung der Modelldatei, gestrichelt für Einstellungen der Versuche dazwischen. Punkte sind die gemessenen Kräfte bei Spitzengeschwindigkeit, in der Farbe ihrer Einstellung.
family-table = Mittel über die Versuche jeder Einstellung. Die FV-Kurve ist an die Versuche dieser Einstellung angepasst. Jeder Versuch ist in Prozent seiner eigenen größten Kraft.
family-clamped = { $setting } (begrenzt)
family-errors-section = Fehler bei jeder Einstellung
family-left-out-table = Mittlerer Fehler über die mittleren Zyklen der angepassten Versuche. Die Familie ohne eine Einstellung ist an alle anderen angepasst und interpoliert; an den Enden des Gitters gibt es keine. Jeder Versuch ist in Prozent seiner eigenen größten Kraft. Eine Anpassung an eine Einstellung allein hat weniger Punkte der FV-Kurve, daher kann die Familie besser sein.
family-own-fit = Anpassung an sie allein
family-fit = Familie
family-without = Familie ohne sie
col-ratio = Verhältnis
family-loops-section = Schleifen nach Einstellung
family-loops-about = Eine Bewegung bei jeder Einstellung, die sie hat: { $amplitude } mm Amplitude, Spitzengeschwindigkeit { $velocity } mm/s.
family-worst-about = Darunter bei jeder Einstellung der Versuch mit dem größten Fehler in Prozent.
family-worst-caption = { $setting }: { $test }, mittlerer Fehler { $error } N, { $percent } %
plot-surface = Kraft über Geschwindigkeit und Einstellung
surface-caption = Kraft des Modells bei konstanter Geschwindigkeit. Farbige Linien sind die Einstellungen der Modelldatei, graue Linien konstante Geschwindigkeiten und Einstellungen dazwischen. Punkte sind die gemessenen Kräfte bei Spitzengeschwindigkeit.
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
responses-late = Das Modell folgt nicht allen Sprüngen. Seine Kraft erreicht 63 % später (+) oder früher (−) als gemessen, um mehr als die Unsicherheit der Messung: { $steps }.
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
undecided = unentschieden
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
certificate-fail = NICHT BESTANDEN. Der Dämpfer hält { $failed } von { $count ->
        [one] { $count } Grenzwert
       *[other] { $count } Grenzwerten
    } nicht ein.
certificate-fail-untested = NICHT BESTANDEN. { $failed } von { $tested ->
        [one] { $tested } geprüften Grenzwert
       *[other] { $tested } geprüften Grenzwerten
    } { $failed ->
        [one] ist
       *[other] sind
    } nicht eingehalten; { $untested ->
        [one] { $untested } weiterer war
       *[other] { $untested } weitere waren
    } mit diesen Messungen nicht prüfbar: { $why }.
certificate-untested = UNVOLLSTÄNDIG. { $tested ->
        [one] Der geprüfte Grenzwert ist
       *[other] Die { $tested } geprüften Grenzwerte sind
    } eingehalten; { $untested ->
        [one] { $untested } weiterer war
       *[other] { $untested } weitere waren
    } mit diesen Messungen nicht prüfbar: { $why }.
certificate-nothing-tested = UNVOLLSTÄNDIG. { $count ->
        [one] Der Grenzwert war mit diesen Messungen nicht
       *[other] Keiner der { $count } Grenzwerte war mit diesen Messungen
    } prüfbar: { $why }.
certificate-why-untested = es fehlt ein Versuch bei dieser Geschwindigkeit oder einer, der für Reibung und Gaskraft langsam genug ist
certificate-why-untested-at-setting = es fehlt ein Versuch bei dieser Geschwindigkeit und Einstellung, einer, der für Reibung und Gaskraft langsam genug ist, oder ein solcher Sprung der Einstellung
certificate-unsure = { $verdict }, nicht sicher: die gemessene Zeit ist auf ± { $value } ms bekannt
certificate-damping = { $verdict }; { $value } N davon wachsen mit der Geschwindigkeit, sind also Dämpfung
certificate-interpolated = { $tests }, interpoliert
certificate-step = Sprung von { $from } auf { $to }: { $tests }
certificate-model-passes = Das Modell kommt bei jedem Grenzwert zum selben Urteil.
certificate-model-fails = Das Modell kommt bei { $count ->
        [one] einem
       *[other] { $count }
    } der Grenzwerte zu einem anderen Urteil als die Messung; eine Simulation zeigt dort also einen anderen Dämpfer.
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
made-all = { $count ->
        [one] Die Datei
       *[other] Alle { $count } Dateien zusammen
    }: SHA-256 { $hash } (der Zeilen, die sha256sum von ihnen in dieser Reihenfolge zeigt).
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
fit-answer = An { $tests ->
        [one] einen Versuch
       *[other] { $tests } Versuche
    } angepasst, Abweichung { $error }.
quality-sentence = { $grade }: Das Modell verfehlt die gemessene Kraft im Mittel um { $error } N ({ $percent } % der größten Kraft), { $beside }; { $curve }.
quality-noise = So gut, wie es das Rauschen erlaubt
quality-good = Gute Anpassung
quality-fair = Mäßige Anpassung
quality-poor = Schlechte Anpassung
quality-beside-noise = das { $ratio }-Fache des Rauschens der Messungen ({ $noise } N)
quality-beyond-noise = das { $ratio }-Fache des Rauschens der Messungen ({ $noise } N), die Versuche zeigen also mehr, als das Modell enthält
quality-noise-unknown = das Rauschen dieser Messungen ist nicht bekannt
quality-curve-worse = die FV-Kurve allein verfehlt sie um { $error } N ({ $percent } %), { $ratio }-mal so viel
quality-curve-no-worse = die FV-Kurve allein ist etwa gleich gut oder besser, { $error } N ({ $percent } %)
quality-worst = In Prozent am schlechtesten ist es in { $test }: im Mittel { $error } N ({ $percent } % der größten Kraft dieses Versuchs; die FV-Kurve allein { $curve } N).
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
error-unseen = { $tests ->
        [one] In dem Versuch, den
       *[other] In den { $tests } Versuchen, die
    } keine Anpassung gesehen hat, geht der Fehler von { $before } auf { $after } N effektiv
error-fitted = Kein Versuch wurde zurückgehalten (zu wenige oder keiner benannt); die Zahlen zeigen also, wie gut das Modell passt, nicht wie gut es vorhersagt: der Fehler geht von { $before } auf { $after } N effektiv
rating-left-out = { $grade }: in den ausgelassenen Versuchen verfehlt das Modell die gemessene Kraft um { $error } N effektiv, das { $ratio }-Fache ihres Rauschens.
rating-fitted = { $grade }: in den angepassten Versuchen verfehlt das Modell die gemessene Kraft um { $error } N effektiv, das { $ratio }-Fache ihres Rauschens.
gap-is-closed = { $error }; { $gap } der Lücke zwischen Modell und Rauschen sind geschlossen, jeder Versuch gemessen an seinem eigenen Rauschen.
gap-grows = { $error }; die Lücke zwischen Modell und Rauschen wächst um { $gap }, jeder Versuch gemessen an seinem eigenen Rauschen.
nothing-stays = Das Modell bleibt, wie es ist; nur seine Zahlen wurden neu angepasst.
changed-stays = Das Modell behält seine Form; seine Zahlen sind jetzt die dieses Dämpfers.
nothing-added-rivals = Es wurde nichts hinzugefügt: unter Namen zu raten, die die Messung gleich gut erklären, wäre wertlos. Die möglichen Ursachen stehen unten, ebenso die Versuche, die entscheiden würden.
nothing-added-unknown = Es wurde nichts hinzugefügt: die Abweichung ist unten ohne Namen beschrieben. Ihr Verlauf über Geschwindigkeit, Weg und Zeit zeigt, wonach am Dämpfer oder am Prüfstand zu suchen ist.
worse-tests = { $count } von { $all } zurückgehaltenen Versuchen { $count ->
        [one] weicht
       *[other] weichen
    } stärker ab als vorher, zum Beispiel { $test }.
row-before = vorher (das gegebene Modell, neu angepasst)
col-fitted-rms = angepasste Versuche, N effektiv
col-their-noise = deren Rauschen, N effektiv
col-left-out-rms = zurückgehaltene Versuche, N effektiv
mean-cycles-caption = An mittleren Zyklen, die weniger rauschen als einzelne. Fehler in Prozent: mittleres |berechnet − gemessen| eines Versuchs durch seine größte Kraft, Mittel über alle Versuche.
whole-deviation = im Mittel { $error } N ({ $percent } %)
whole-records = Über alle Abtastwerte aller Messungen, wie dashpot validate misst: { $came } mit dem gegebenen Modell, { $refitted } neu angepasst, { $improved } verbessert. Die Zahlen darüber gelten für mittlere Zyklen, in denen das Rauschen herausgemittelt ist.
whole-records-refitted = Über alle Abtastwerte aller Messungen, wie dashpot validate misst: { $came } mit dem gegebenen Modell, { $refitted } neu angepasst. Die Zahlen darüber gelten für mittlere Zyklen, in denen das Rauschen herausgemittelt ist.
whole-records-other = So, wie es kam, verfehlt das Modell diese Messungen um { $came }; neu angepasst um { $refitted }. Es beschreibt also einen anderen Dämpfer, eine andere Einstellung oder eine andere Temperatur, und seine Zahlen haben sich verschoben.

## The picture of a diagnosis.

name-and-sure = { $name } ({ $sure } sicher)
picture-named = Dieser Dämpfer zeigt: { $names }
picture-nothing = Es fehlt kein bekannter Effekt
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
status-added-unnamed = hinzugefügt, nicht genannt
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
finding-disagreement = { " " }Ohne ihn kommen { $gap } der Abweichung zurück.
finding-of-rig = Der Effekt gehört zum Prüfstand, nicht zum Dämpfer: im Vergleich berichtigt, nicht ins Modell übernommen.
finding-added = Der Effekt ist dem verbesserten Modell hinzugefügt.
finding-what = { $meaning }. { $added }{ $gap }
finding-why = Wo: { $path } (Familie: { $family }, { $family_sure } sicher). Mit ihm ist das Residuum in { $tests } der Versuche kleiner.
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
loop-grown = { " " }Die Lücke ist um { $gap } gewachsen.

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
group-note = { $groups }: { $text }
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
numbers-caption = Zahlen des Modells, die sich in mindestens einer Gruppe stärker von der Referenz unterscheiden, als beide offenlassen. Darunter die Zahlen der benannten Effekte.
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
name-share = Verhältnis
name-share-across = Verhältnis in Querphase
name-share-growth = Zunahme des Verhältnisses
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
name-oil-chambers = kompressible Kammern
name-oil-compression = Verhältnis der Ölsteifigkeiten
name-aeration-stroke = Luftweg
name-aeration-force = Kraft zum Schließen der Luft
name-aeration-compression = Luftverhältnis der Druckstufe
name-cavitation-force = Kavitationsgrenze
name-cavitation-side = kavitierende Richtung
name-cavitation-return = Kraft auf dem Rückweg
name-cavitation-form = Form der Kavitation
name-cavitation-velocity = Grenzgeschwindigkeit des Bodenventils
name-cavitation-unfilled = nicht nachgefüllter Bruchteil des Stroms
name-lost-stroke = Totgang
name-cavitation-onset = Beginn der Kavitation
name-cavitation-expansion = Aufweitung des Hohlraums

## Names. Over the stroke.

name-bypass-share = Kraftminderung in der Zone
name-bypass-centre = Mitte der Zone
name-bypass-half-width = halbe Breite der Zone
name-bypass-blend = Übergang der Zone
name-bypass-strokes = Richtungen der Zone
name-bypass-form = Form der Zone
name-bypass-flow = Strom durch die Nut

## Names. Heat.

name-fade-source = Herkunft der Temperatur
name-fade-coefficient = Abnahme der Dämpfung je Kelvin
name-fade-reference = Bezugstemperatur
name-heat-capacity = Wärmekapazität
name-heat-transfer = Wärmestrom je Kelvin
name-fade-laminar-force = Grenzkraft laminarer Strömung
name-fade-slackening = Temperaturabhängigkeit der Abnahme

## Names. Valves.

name-fsd-form = Form der Frequenzabhängigkeit
name-fsd-share = Kraftverlust bei hoher Frequenz
name-fsd-time = Zeitkonstante der Frequenzabhängigkeit
name-fsd-velocity = Füllgeschwindigkeit der Steuerkammer
name-fsd-flow = Bypass-Strom
name-fsd-force = Füllkraft der Steuerkammer
name-fsd-laminar-force = Laminargrenze des Bypasses
name-valve-hysteresis-share = Kraftzuwachs durch die Ventilverzögerung
name-valve-opening-force = Öffnungskraft des Ventils
name-valve-closing-ratio = Verhältnis Schließ- zu Öffnungskraft
name-valve-time = Zeitkonstante des Ventils
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
name-stribeck-rise = Steilheit des Anstiegs
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
element-series-compliance = Feder und Dämpfer in Reihe mit der inneren Masse: Nachgiebigkeit von Gas, Öl und Lagern
element-free-play = Spiel in einem Auge oder Lager; braucht series_compliance
element-bushing = Gummilager in Reihe mit dem Dämpfer: versteifende Feder mit Hysterese; braucht series_compliance
element-oil-compressibility = Kompressibilität der Ölsäule vor den Ventilen, Aufweitung des Zylinders eingeschlossen
element-aeration = freie Luft im Öl: geringe Steifigkeit der Ölsäule bei kleinen Kräften
element-cavitation = Kavitation: eine Hubrichtung öffnet einen Hohlraum, den der Rückhub wieder schließen muss
element-position-dependent-damping = hubabhängige Dämpfung: geringer (Bypass) oder höher über einen Teil des Hubs
element-temperature-fade = Temperaturabfall der Dämpfung mit der Öltemperatur, gemessen oder aus der Eigenerwärmung
element-frequency-selective-damping = frequenzselektive Dämpfung: bei gleicher Geschwindigkeit bei hoher Hubfrequenz geringer als bei niedriger
element-valve-hysteresis = Überdruckventil, das verzögert öffnet und schließt: höhere Kraft bei steigender Geschwindigkeit
element-parallel-spring = Feder parallel zum Grunddämpfer: linear, quadratisch, kubisch, vierten Grades oder als Tabelle
element-coulomb-friction = Coulomb-Reibung: Trockenreibung konstanten Betrags, F_s tanh(K v)
element-stribeck-friction = Stribeck-Reibung: Trockenreibung mit Losbrechspitze
element-viscous-friction = viskose Reibung, quadratisch in der Geschwindigkeit, F_v v|v|
element-side-force-friction = Trockenreibung proportional zur Seitenkraft auf die Stange
element-gas-preload = konstante Gaskraft
element-gas-warming = Gaskraft, die mit der Temperatur des Dämpfers zunimmt
element-lagged-polynomial = FV-Kurve als Polynom mit Verzögerung erster Ordnung, deren Zeitkonstante von der Geschwindigkeit abhängt
element-presliding-friction = Reibung mit Vorgleiten (Dahl): nach jeder Umkehr wechselt sie über einen kurzen Weg das Vorzeichen
element-gas-spring = Änderung der Gaskraft mit dem Weg der Stange, isotherm bis adiabat
element-moving-mass = Trägheit einer Masse zwischen Kraftmessdose und Dämpfer, die das bewegte Ende antreibt, oder einer, die der Kolben antreibt
element-bump-stop = Druckanschlag am Ende des Druckhubs, Gummi oder hydraulisch
element-rebound-stop = Zuganschlag am Ende des Zughubs, Gummi oder hydraulisch
element-integration = Einstellungen der Integration mit fester Schrittweite
element-channel-delay = der Kraftkanal kommt später als die Kanäle der Bewegung (Prüfstand)
element-force-offset = die Kraftmessdose zeigt ohne Last nicht null (Prüfstand)
element-force-drift = der Nullpunkt der Kraftmessdose wandert mit der Zeit (Prüfstand)

## What parameters mean.

parameter-fv-form = Herkunft der FV-Kurve: Tabelle, oder Dämpfungsbeiwerte und Knickgeschwindigkeiten
parameter-fv-interpolation = Interpolation zwischen den Punkten der FV-Tabelle
parameter-fv-velocity = Geschwindigkeiten der FV-Tabelle, Zugstufe positiv, steigend
parameter-fv-force = Kräfte der FV-Tabelle, Zugkraft positiv, nicht fallend
parameter-fv-rebound-c1 = Cr1: Dämpfungsbeiwert der Zugstufe unter dem ersten Knick
parameter-fv-rebound-c2 = Cr2: Dämpfungsbeiwert der Zugstufe zwischen den Knicken
parameter-fv-rebound-c3 = Cr3: Dämpfungsbeiwert der Zugstufe über dem zweiten Knick
parameter-fv-rebound-v1 = Geschwindigkeit am ersten Knick der Zugstufe
parameter-fv-rebound-v2 = Geschwindigkeit am zweiten Knick der Zugstufe
parameter-fv-compression-c1 = Cc1: Dämpfungsbeiwert der Druckstufe unter dem Knick
parameter-fv-compression-c2 = Cc2: Dämpfungsbeiwert der Druckstufe über dem Knick
parameter-fv-compression-v1 = Geschwindigkeitsbetrag am Knick der Druckstufe, positiv
parameter-series-stiffness = Steifigkeit der Reihenfeder, k_s
parameter-series-damping = Dämpfungsbeiwert parallel zur Reihenfeder, c_s
parameter-internal-mass = innere bewegte Masse von Stange, Öl und Gas, m
parameter-series-load = Kräfte, die die Reihenfeder trägt: hydraulische Kraft und Parallelfeder, oder zusätzlich Reibung und Gaskraft (Auge oder Lager)
parameter-free-play-gap = gesamtes Spiel von Anlage zu Anlage, 2 g
parameter-free-play-force = Weichheit der Anlage: Kraft über F_1 hinaus, die das Spiel zur Hälfte schließt, F_0
parameter-free-play-load = Last in der Mitte des Spiels, F_1: Gewicht am Auge, Gaskraft, Verspannung
parameter-bushing-hardening = Einfederung, bei der die Versteifung die Kraft der Reihenfeder verdoppelt, d_h
parameter-bushing-loss-stiffness = Steifigkeit des schnell relaxierenden Zweigs (Maxwell) durch Reihensteifigkeit, k_1/k_s
parameter-bushing-loss-time = Relaxationszeit des schnellen Zweigs, tau
parameter-bushing-slip = Einfederung, über die Füllstoffreibung den schnellen Zweig entspannt, d_f; groß: Relaxation nur mit der Zeit
parameter-bushing-stop = Einfederung, bei der der Gummi in jeder Richtung einen Anschlag trifft, L
parameter-bushing-stop-stiffness = zusätzliche Steifigkeit des Anschlags durch Reihensteifigkeit, k_e/k_s; 0: kein Anschlag
parameter-bushing-slow-stiffness = Steifigkeit des langsam relaxierenden Zweigs (Maxwell) durch Reihensteifigkeit, k_2/k_s; 0: kein solcher Zweig
parameter-bushing-slow-time = Relaxationszeit des langsamen Zweigs, tau_2
parameter-oil-stiffness = Steifigkeit der Ölsäule bei x = 0, Aufweitung des Zylinders eingeschlossen, k_o
parameter-oil-shortening = Kehrwert der Länge der Ölsäule bei x = 0, lambda; 0: Steifigkeit unabhängig von der Position
parameter-oil-chambers = Kammer mit kompressibler Ölsäule: stets die Zugkammer, oder die Kammer unter Druck
parameter-oil-compression = Verhältnis der Steifigkeit der Ölsäule in der Druckstufe zu der in der Zugstufe, r_o
parameter-aeration-stroke = Weg, den die Kompression der Luft in der Zugstufe aufnimmt, d_a
parameter-aeration-force = Kraft, bei der die Luft die Hälfte ihres Wegs aufgenommen hat, F_a
parameter-aeration-compression = Verhältnis des Wegs, den die Luft in der Druckstufe aufnimmt, zu dem in der Zugstufe, r_a
parameter-cavitation-force = größte hydraulische Kraft in der kavitierenden Richtung, C
parameter-cavitation-side = Hubrichtung, in der Kavitation auftritt
parameter-cavitation-return = Bruchteil von C, der auf dem Rückhub wirkt, während der Hohlraum sich schließt; 1: Gas drückt weiter, 0: keine Kraft
parameter-cavitation-form = Ursache des Hohlraums: begrenzte Kraft in der kavitierenden Richtung, oder ein Bodenventil, das die Kammer hinter dem Kolben nicht nachfüllt
parameter-cavitation-velocity = Bodenventil: Geschwindigkeit in der kavitierenden Richtung, über der die Kammer nicht vollständig nachgefüllt wird, v_f
parameter-cavitation-unfilled = Bodenventil: Bruchteil des Stroms über v_f, der nicht nachgefüllt wird, a
parameter-cavitation-onset = Grenzkraft: Kraft, bei der der Hohlraum sich öffnet, als Bruchteil von C, alpha; 1: bei C
parameter-cavitation-expansion = Grenzkraft: Tiefe des Hohlraums, bei der das sich ausdehnende Gas die Kraft auf halbem Weg von alpha C bis C hat, e_1
parameter-bypass-share = Bruchteil, um den die FV-Kraft in der Zone verringert ist, a; negativ: erhöht
parameter-bypass-centre = Weg in der Mitte der Zone, c
parameter-bypass-half-width = halbe Länge der Zone, w
parameter-bypass-blend = Übergangslänge an jedem Ende der Zone, b
parameter-bypass-strokes = Hubrichtungen, in denen die Zone wirkt
parameter-bypass-form = Faktor auf die FV-Kraft, oder Bypass-Strom parallel zu den Ventilen
parameter-bypass-flow = Nut: Bypass-Strom in der Zone bei einer hydraulischen Kraft von 1 kN, als Kolbengeschwindigkeit, q_b
parameter-fade-source = Öltemperatur: gemessen, oder Umgebungstemperatur plus berechnete Eigenerwärmung
parameter-fade-coefficient = relative Abnahme der Dämpfung je Kelvin, alpha
parameter-fade-reference = Bezugstemperatur der FV-Kurve, T_0
parameter-heat-capacity = Wärmekapazität von Öl und Dämpfergehäuse, C_h
parameter-heat-transfer = Wärmestrom an die Umgebung je Kelvin Temperaturdifferenz, h
parameter-fade-laminar-force = FV-Kraft, von der die Hälfte laminar ist und nachlässt, F_l; groß: sie lässt ganz nach
parameter-fade-slackening = Temperaturabhängigkeit der Abnahme, kappa; 0: Exponentialgesetz, 1/(T_0 + 95 degC): Gesetz von Vogel
parameter-fsd-form = Bruchteil der Kraft, der nacheilt, Bruchteil, der sich in jedem Hub aufbaut, oder Bypass-Strom, der in jedem Hub endet
parameter-fsd-share = Bruchteil der Kraft, der bei hoher Frequenz fehlt, a
parameter-fsd-time = Zeitkonstante des Nacheilens oder des Füllens der Steuerkammer, tau
parameter-fsd-velocity = Form „stroke“: Geschwindigkeit, über der die Steuerkammer sich mit voller Rate füllt, u_0
parameter-fsd-flow = Form „bypass“: Bypass-Strom bei einer hydraulischen Kraft von 1 kN, als Kolbengeschwindigkeit, q_s
parameter-fsd-force = Form „bypass“: hydraulische Kraft, über der die Steuerkammer sich mit voller Rate füllt, F_0
parameter-fsd-laminar-force = Form „bypass“: hydraulische Kraft, unter der der Bypass-Strom laminar ist, F_l
parameter-valve-hysteresis-share = Form „opening“: größte Kraft, die die Verzögerung hinzufügt, als Bruchteil der FV-Kraft, eta
parameter-valve-opening-force = Kraft, bei der das Ventil öffnet
parameter-valve-closing-ratio = Form „opening“: Verhältnis der Schließkraft zur Öffnungskraft; 1: Verzögerung allein durch die Zeitkonstante
parameter-valve-time = Zeitkonstante der Ventilbewegung, tau; Form „spool“: Eigenperiode durch 2 pi
parameter-valve-width = Kraftbereich, über den das Ventil öffnet, b
parameter-valve-form = eine Öffnung, die nacheilt, oder ein Ventil, dessen Stellung bei jeder Kraft durch Reibung oder Masse nacheilt
parameter-valve-play = Form „play“: Kraftänderung, die das Ventil nicht bewegt (Reibung), P
parameter-valve-damping = Form „spool“: Dämpfungsmaß des Ventils, zeta
parameter-spring-linear = lineare Steifigkeit, k_p in k_p x
parameter-spring-quadratic = quadratische Steifigkeit, k_p in k_p x|x|
parameter-spring-cubic = kubische Steifigkeit, k_p in k_p x^3
parameter-spring-quartic = Steifigkeit vierten Grades, k_p in k_p x^3|x|
parameter-spring-displacement = Wege der Federtabelle, steigend; leer: keine Tabelle
parameter-spring-force = Kräfte der Federtabelle, nicht fallend
parameter-coulomb-force = Betrag der Reibkraft, F_s
parameter-coulomb-steepness = Steilheit des Vorzeichenwechsels bei Geschwindigkeit null, K
parameter-stribeck-form = Form der Stribeck-Kurve
parameter-stribeck-breakaway-force = Losbrechkraft (Spitze), F_brk oder F_t
parameter-stribeck-coulomb-force = Coulomb-Reibkraft jenseits der Spitze, F_c oder F_s
parameter-stribeck-breakaway-velocity = Geschwindigkeit an der Losbrechspitze, v_brk oder V_fs
parameter-stribeck-velocity = volle Form: Stribeck-Geschwindigkeit, Maß des Abfalls nach der Spitze, V_s
parameter-stribeck-fall = volle Form: Exponent des Abfalls nach der Spitze, a (1 Tustin, 2 Gauß)
parameter-stribeck-rise = volle Form: Steilheit des Anstiegs zur Spitze, c; groß: die Spitze erreicht F_t
parameter-stribeck-rise-power = volle Form: Exponent des Anstiegs zur Spitze, d
parameter-viscous-coefficient = Reibbeiwert, F_v in F_v v|v|
parameter-side-force-coefficient = Reibbeiwert: Reibkraft durch Seitenkraft, k_avg
parameter-side-force-steepness = Steilheit des Vorzeichenwechsels bei Geschwindigkeit null, K
parameter-gas-force = Gaskraft, positiv, wo sie die Stange hinausdrückt
parameter-gas-warming-rate = Zunahme der Gaskraft je Kelvin, c
parameter-gas-warming-reference = Temperatur, bei der dieses Element keine Gaskraft hinzufügt, T_0
parameter-polynomial = Koeffizienten der FV-Kurve als Polynom, von v^0, v^1, ...
parameter-lag-slow = Zeitkonstante der Verzögerung bei kleiner Geschwindigkeit
parameter-lag-fast = Zeitkonstante der Verzögerung bei hoher Geschwindigkeit
parameter-lag-v1 = Geschwindigkeit, unter der die Zeitkonstante die der kleinen Geschwindigkeit ist
parameter-lag-v2 = Geschwindigkeit, über der die Zeitkonstante die der hohen Geschwindigkeit ist
parameter-presliding-force = Reibkraft nach langem Weg, F_c
parameter-presliding-length = Vorgleitweg: Weg, auf dem der Abstand zu F_c um den Faktor e abnimmt, z_0
parameter-presliding-power = Exponent des Gleitens, n; 1: Gleiten von Anfang an (Dahl), größer: elastische Verformung vor dem Gleiten
parameter-presliding-return = Entlastung nach einer Umkehr: mit Gleiten oder elastisch
parameter-presliding-creep = Geschwindigkeit, unter der der Kontakt kriecht, v_c
parameter-gas-stiffness = isotherme Gassteifigkeit bei x = 0, k
parameter-gas-length = Gasvolumen bei x = 0 durch die Stangenfläche, L; kürzer: progressiver
parameter-gas-adiabatic-index = Adiabatenexponent: Verhältnis von adiabater zu isothermer Steifigkeit, gamma
parameter-gas-thermal-time = thermische Zeitkonstante zwischen Gas und Wand, tau
parameter-moving-mass = bewegte Masse, M
parameter-moving-mass-time = Nacheilen der Trägheitskraft, tau; kurz gegenüber der Bewegung
parameter-moving-mass-place = Punkt, der die Masse antreibt: bewegtes Ende des Dämpfers, oder Kolben hinter der Reihensteifigkeit
parameter-bump-stop-clearance = Einfederung von x = 0 bis zum ersten Kontakt mit dem Anschlag, positiv
parameter-bump-stop-stiffness = Steifigkeit des Anschlags beim ersten Kontakt
parameter-bump-stop-progression = Einfederung des Anschlags, bei der seine Federkraft das Doppelte der linearen ist
parameter-bump-stop-loss = Bruchteil der Federkraft, der bei Belastung und nochmals bei Entlastung verloren geht
parameter-bump-stop-damping = hydraulischer Dämpfungsbeiwert bei Belastung, bei der Einfederung der Progression
parameter-bump-stop-flow = hydraulische Kraft proportional zur Geschwindigkeit (Spalt) oder zu ihrem Quadrat (Blende), bei 1 m/s gleich
parameter-rebound-stop-clearance = Ausfederung von x = 0 bis zum ersten Kontakt mit dem Anschlag
parameter-rebound-stop-stiffness = Steifigkeit des Anschlags beim ersten Kontakt
parameter-rebound-stop-progression = Einfederung des Anschlags, bei der seine Federkraft das Doppelte der linearen ist
parameter-rebound-stop-loss = Bruchteil der Federkraft, der bei Belastung und nochmals bei Entlastung verloren geht
parameter-rebound-stop-damping = hydraulischer Dämpfungsbeiwert bei Belastung, bei der Einfederung der Progression
parameter-rebound-stop-flow = hydraulische Kraft proportional zur Geschwindigkeit (Spalt) oder zu ihrem Quadrat (Blende), bei 1 m/s gleich
parameter-method = Integrationsverfahren innerhalb eines Schritts; automatic: das billigste mit einem Fehler unter einem Tausendstel in einem Schritt von 1 ms
parameter-substeps = Teilschritte innerhalb eines Schritts des Programms; 0: so viele, wie Steifigkeit und Dämpfung des Modells verlangen

# What reading says of records.

## What reading says of records. Lists.

records-comma = ,{ " " }
records-semicolon = ;{ " " }
records-quoted = „{ $test }“
records-and-more = { $names } und { $count } weitere
records-or = { " " }oder{ " " }

## What reading says of records. Files and tables.

records-profile = nach { $file } gelesen
records-stray = in { $folder } nicht als Messungen gelesen: { $names }
records-below = die Unterordner von { $folder } enthalten { $count ->
        [one] { $count } Datei, die nicht gelesen wurde
       *[other] { $count } Dateien, die nicht gelesen wurden
    } ({ $names }); sind es Versuche am selben Dämpfer, so liest --subfolders auch sie
records-columns-not-read = nicht gelesene Spalten: { $names }
records-by-unit = „{ $column }“ wird allein wegen der Einheit als { $channel } gelesen; ist eine andere Spalte gemeint, sagt es --column
records-converted = in SI umgerechnet: { $channels }
records-from-unit = { $channel } aus { $unit }
records-time-of-day = Uhrzeit ab der ersten Zeile gezählt
records-one-clock = die Messungen stehen nach Datum und Uhrzeit in ihren Dateien auf einer gemeinsamen Uhr, von { $first } bis { $last }: Wärme und Driften reichen von Datei zu Datei
records-dates-assumed = im Datum { $date } (von { $at }) kann der Tag oder der Monat vorn stehen, und nichts in den Dateien entscheidet es; es wurde als { $read } gelesen, { $why }. --dates day-first (Tag zuerst) oder month-first (Monat zuerst) legt es fest (dates in campaign.toml)
records-dates-close = denn so liegen die Versuche nahe beieinander
records-dates-american = mit dem Monat zuerst, wie zwischen Schrägstrichen in Amerika
records-dates-usual = mit dem Tag zuerst, wie zwischen Bindestrichen üblich
records-own-clocks = jede Messung hat ihre eigene Uhr, so dass Wärme und Driften nicht von Datei zu Datei reichen: { $why }
records-some-without-date = nur { $count } von { $all } Dateien { $count ->
        [one] nennt
       *[other] nennen
    } den Beginn des Versuchs
records-too-far-apart = nach den Zeiten in ihren Dateien liegen sie für eine Messreihe zu weit auseinander
records-clocks-overlap = nach den Zeiten in ihren Dateien überlappen sie sich; das können die Zeiten eines Exports sein
records-two-rates = in einer eigenen Gruppe mit höherer Rate gemessen und linear auf die Zeiten der langsameren Kanäle gelegt: { $names }
records-cut-off = die Datei brach beim Schreiben ab, daher fehlen Daten am Ende; { $rows ->
        [one] die vollständige Zeile davor wurde
       *[other] die { $rows } vollständigen Zeilen davor wurden
    } gelesen. Den Versuch neu messen, falls er länger sein sollte
records-stale-rows = { $count ->
        [one] die erste Zeile (bis Zeile { $line }) gehört
       *[other] die ersten { $count } Zeilen (bis Zeile { $line }) gehören
    } zu einem früheren Lauf, denn danach springt die Zeit von { $from } s auf { $to } s zurück; weggelassen
records-crank = die Zeit ist aus dem Kurbelwinkel bei { $rpm } Umdrehungen pro Minute berechnet
records-resampled = mit anderer Rate gemessen und durch gerade Linien auf die Zeiten von Kraft und Bewegung gebracht: { $names }
records-below-heading = Zeile { $line } unter der Überschrift enthält keine Zahlen: { $text }
records-below-table = ab Zeile { $line }, unter der Tabelle, nicht gelesen: { $text }
records-between-rows = { $count ->
        [one] { $count } Zeile zwischen den Messwerten enthält keine Zahlen und wurde
       *[other] { $count } Zeilen zwischen den Messwerten enthalten keine Zahlen und wurden
    } übergangen (Zeile { $lines }), die erste: { $text }
records-behind-rows = { $count ->
        [one] { $count } Zeile enthält
       *[other] { $count } Zeilen enthalten
    } hinter den Spalten der Überschrift Text, der nicht gelesen wurde (Zeile { $lines }), der erste: { $text }
records-longer-rows = { $count ->
        [one] { $count } Zeile enthält
       *[other] { $count } Zeilen enthalten
    } mehr Zahlen, als die Überschrift Spalten hat, sodass nicht sicher ist, welche wohin gehört; { $count ->
        [one] diese Zeile ist
       *[other] diese Zeilen sind
    } weggelassen (Zeile { $lines }). Zu viel in der ersten: { $text }

## What reading says of records. Gaps in time.

records-of-file = { $file }: { $text }
records-of-files = { $count ->
        [one] { $count } Datei
       *[other] { $count } Dateien
    } ({ $names }, ...) mit einem Hinweis derselben Art, der erste: { $text }
records-gaps = Lücken in der Zeit: { $places }{ $more }. Als { $count ->
        [one] { $count } Versuch
       *[other] { $count } Versuche
    } gelesen{ $rest }
records-gap = { $seconds } s ohne Messwerte nach { $from } s (Zeile { $line })
records-more-gaps = { " " }und { $count } weitere
records-too-few-between = ; { $count ->
        [one] { $count } Messwert zwischen Lücken ist zu wenig
       *[other] { $count } Messwerte zwischen Lücken sind zu wenige
    } für einen Versuch
records-stumps = { $count ->
        [one] { $count } Stück neben einer Lücke enthält keinen ganzen Zyklus und wurde
       *[other] { $count } Stücke neben einer Lücke enthalten keinen ganzen Zyklus und wurden
    } weggelassen: { $places }
records-from-to = { $from } bis { $to } s
records-at-speeds = { $count } Versuche hintereinander, Hübe konstanter Geschwindigkeit, getrennt, wo sich die Geschwindigkeit ändert; die Uhr läuft weiter, sodass Wärme übertragen wird
records-speed-of-strokes = die Geschwindigkeit ist die des ganzen Hubs, denn ein Hub hat zu wenige Messwerte für einen Verlauf
records-at-settings = { $count } Versuche hintereinander ohne Pause, getrennt, wo sich Hub oder Frequenz ändert und so bleibt; die Uhr läuft weiter, damit die Wärme mitgeht
records-at-rests = { $count } Versuche hintereinander, an den Ruhezeiten dazwischen getrennt nach der Bewegung davor und danach; um ganze Zyklen herum ist die Ruhe abgeschnitten, und die Uhr läuft weiter, so dass Wärme mitgeht

## What reading says of records. Rows.

records-overflows = { $count ->
        [one] { $count } Wert
       *[other] { $count } Werte
    } des Kanals { $channel } größer, als ein Sensor misst, zuerst { $value } { $unit } in Zeile { $line }; als fehlend behandelt
records-rows-dropped = { $count } von { $rows } Zeilen wegen leerer Zellen oder solcher ohne Zahl weggelassen (Zeile { $lines })
records-setting-held = { $count } von { $rows } Werten der Einstellung ‚{ $setting }‘ { $count ->
        [one] fehlt
       *[other] fehlen
    }; jeder gilt als der vor ihm
records-setting-start = die Einstellung „{ $setting }“ ist { $seconds } s lang auf dem Weg zu ihrem Wert; dieser Anfang wurde abgeschnitten
records-setting-empty = die Spalte der Einstellung ‚{ $setting }‘ ist leer: der Versuch gilt als einer ohne sie, oder wie sein Name sagt
records-unread-current = die Spalte „{ $column }“ in { $unit } wird nicht gelesen; ist sie der Strom des Dämpferventils, so geben Sie --column current='{ $column }' an, sonst --ignore current
records-unread-setting = die Spalte „{ $column }“ in { $unit } wird nicht gelesen; ist sie die Einstellung des Dämpferventils, so geben Sie --column setting='{ $column }' an, sonst --ignore current
records-small-current = der Strom beträgt höchstens { $current } mA und gilt als 0 A, denn darauf antwortet kein Ventil; stehen in der Spalte A, so geben Sie --unit current=A an
records-filled = { $count ->
        [one] { $count } fehlender Wert
       *[other] { $count } fehlende Werte
    } im Kanal { $channel } durch Geraden ergänzt
records-empty-column = die Spalte des Kanals { $channel } ist leer und wurde weggelassen
records-repeated-rows = { $count ->
        [one] { $count } Zeile
       *[other] { $count } Zeilen
    } in { $blocks ->
        [one] { $blocks } Block
       *[other] { $blocks } Blöcken
    } { $count ->
        [one] wiederholt eine frühere Zeile
       *[other] wiederholen frühere Zeilen
    } samt Zeitstempel, zuerst in Zeile { $line }; entfernt
records-repeated-blocks = { $blocks ->
        [one] { $blocks } Block
       *[other] { $blocks } Blöcke
    }, zusammen { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    }, { $blocks ->
        [one] wiederholt
       *[other] wiederholen
    } die Zeilen unmittelbar davor unter neuen Zeitstempeln (der erste: { $first ->
        [one] { $first } Zeile
       *[other] { $first } Zeilen
    } ab Zeile { $line }); entfernt und die Zeit dahinter aufgeschlossen
records-out-of-order = die Zeit sprang { $count }-mal zurück, zuerst in Zeile { $line }; { $moved ->
        [one] { $moved } Zeile
       *[other] { $moved } Zeilen
    } wieder eingeordnet
records-shared-stamps = { $count } von { $rows } Zeilen { $count ->
        [one] hatte
       *[other] hatten
    } den Zeitstempel der Zeile davor; sie { $count ->
        [one] wurde
       *[other] wurden
    } gleichmäßig bis zum nächsten verteilt

## What reading says of records. Samples.

records-clipped-motion = der Kanal { $channel } ist in { $percent } % der Messwerte bei { $value } { $unit } abgeschnitten, zuerst in Zeile { $line }; er wird weggelassen und aus dem Kanal { $other } gewonnen
records-rounded = { $channel } steht bei { $value } { $unit } in { $count ->
        [one] { $count } Messwert
       *[other] { $count } Messwerten
    }, zuerst in Zeile { $line }; andere Versuche gehen weiter, sodass dies als Umkehr gilt und nicht als Ende des Messbereichs
records-clipped-force = die Kraft ist bei { $value } N abgeschnitten, zuerst in Zeile { $line } (Messwerte: { $count }, { $percent } %); diese Messwerte sind weggelassen
records-spiky = der Kanal { $channel } ist voller Spitzen: { $percent } % der Messwerte heben sich von ihren Nachbarn ab; zu viele für einzelne Störspitzen, so gelassen
records-spikes = Störspitzen des Kanals { $channel } durch Geraden ersetzt, die erste in Zeile { $line }, die größte um { $largest } { $unit } zu weit (Störspitzen: { $spikes }, Messwerte: { $count })

## What reading says of records. Motion.

records-consistent = die Geschwindigkeit ist das { $gain }-Fache der Ableitung des Wegs und { $lag } ({ $percent } % der Varianz des Wegs bleiben unerklärt)
records-no-lag = hat keinen Versatz
records-lags = eilt ihr um { $lag } ms nach
records-leads = eilt ihr um { $lag } ms voraus
records-differentiated = Geschwindigkeit durch Ableiten des Wegs, mit gleitenden kubischen Polynomen über { $points } Messwerte ({ $window } s), ohne Phasenverschiebung, −3 dB bei { $frequency } Hz{ $shorter }
records-shorter = ; über weniger, wo die Bewegung darin umkehrt, { $percent } % der Messwerte
records-integrated = Weg durch Integration der Geschwindigkeit, Beginn bei { $start } mm; Nullpunktfehler der Geschwindigkeit von { $offset } mm/s entfernt, das sind { $drift } mm Drift über die Messung ({ $basis })
records-not-periodic-ends = die Messung ist nicht periodisch, daher wird angenommen, dass der Dämpfer dort endet, wo er begann
records-cycles-return = aus ganzen Zyklen, in denen der Dämpfer jeweils zurückkehrt

## What reading says of records. What the user knows of the sensors.

records-force-zero = Nullpunkt der Kraft von { $force } N abgezogen, wie angegeben
records-gain = Kraft mit { $gain } multipliziert, wie angegeben
records-displacement-zero = Nullpunkt des Wegs von { $displacement } mm abgezogen, wie angegeben
records-force-turned = Vorzeichen der Kraft umgedreht, wie verlangt
records-motion-turned = Vorzeichen von Weg und Geschwindigkeit umgedreht, wie verlangt
records-gain-of = { $channel } mit { $gain } multipliziert
records-mass-taken-off = Kraft abgezogen, die eine Masse von { $mass } kg an der Kraftmessdose bewegt, wie angegeben
records-early-as-given = die Kraft kommt { $delay } ms vor der Bewegung, wie angegeben; die Bewegung wurde dorthin geschoben, die Messwerte der Kraft sind wie aufgezeichnet
records-late-as-given = die Kraft kommt { $delay } ms nach der Bewegung, wie angegeben; die Bewegung wurde dorthin geschoben, die Messwerte der Kraft sind wie aufgezeichnet
records-taken-out = was die Identifikation als Fehler der Messung fand, ist herausgerechnet

## What reading says of records. Cycles.

records-no-cycles = keine ganzen Zyklen gefunden; die Messung bleibt ganz ({ $samples ->
        [one] { $samples } Messwert
       *[other] { $samples } Messwerte
    })
records-trimmed = { $before } s ({ $samples_before ->
        [one] { $samples_before } Messwert
       *[other] { $samples_before } Messwerte
    }) Ruhe und Anlauf vor dem ersten ganzen Zyklus und { $after } s ({ $samples_after ->
        [one] { $samples_after } Messwert
       *[other] { $samples_after } Messwerte
    }) nach dem letzten ({ $tail }) abgeschnitten; { $cycles ->
        [one] { $cycles } Zyklus
       *[other] { $cycles } Zyklen
    } bei { $frequency } Hz { $cycles ->
        [one] bleibt
       *[other] bleiben
    }
records-unlike-cycles = an { $places } Stellen zwischen den Zyklen ist die Bewegung kein ganzer Zyklus wie die anderen (Pause oder Störung); sie bleibt in der Messung, zählt aber nicht zu den Zyklen
records-noisy-last = der letzte Zyklus (ab { $start } s) weicht von den anderen um { $last } N effektiv ab, diese untereinander um { $typical } N; weggelassen
records-displacement-drifts = der mittlere Weg wandert über { $cycles ->
        [one] { $cycles } Zyklus
       *[other] { $cycles } Zyklen
    } um { $drift } mm ({ $percent } % des Hubs); so gelassen
records-force-drifts = die mittlere Kraft wandert über { $cycles ->
        [one] { $cycles } Zyklus
       *[other] { $cycles } Zyklen
    } um { $drift } N ({ $percent } % ihrer Spanne); so gelassen

## What reading says of records. Figures that no damper has.

records-no-force = die Kraft zeigt in { $tests } nur Rauschen; die Kraftmessdose prüfen oder diese Versuche weglassen
records-small-amplitude = die größte Amplitude ist { $amplitude } { $unit }: stimmt die Einheit des Wegs?
records-slow = der schnellste Versuch erreicht { $velocity } { $unit }: stimmen die Einheiten von Zeit und Bewegung? Langsame Versuche allein sagen einem Modell nichts über den Fahrbetrieb
records-small-force = die Kraft ändert sich nie um mehr als { $force } N: stimmt ihre Einheit?
records-torn = { $test }: enthält weniger als einen Zyklus und endet mitten im Hub, bei { $velocity } mm/s von höchstens { $peak } mm/s; ist die Datei abgebrochen, sie neu exportieren oder mit --exclude weglassen
records-twins = { $test } enthält dieselben Messwerte wie { $twin } und zählt doppelt

## What reading says of records. A force that comes late.

records-late = die Kraft kommt etwa { $delay } ms nach der Bewegung: so genommen lässt eine Kurve über der Geschwindigkeit { $left } % ihrer Varianz unerklärt, wie aufgezeichnet { $recorded } %
records-late-not-moved = { $late }{ $energy }. Hysterese sieht hier wie eine Verzögerung aus, deshalb wurde nichts verschoben. dashpot fit trennt beide und meldet die Verzögerung, die es findet; der Rest ist Hysterese des Dämpfers. { $option } nur angeben, wenn der Prüfstand die Kraft bekanntlich um so viel verzögert
records-would-feed = ; wie aufgezeichnet gäbe der Dämpfer in { $count } von { $all ->
        [one] { $all } Versuch
       *[other] { $all } Versuchen
    } Energie ab

## What reading says of records. The direction that the files count positive.

records-standstill = die Kraft im Stillstand ist { $force } N ± { $error } N, wie die Dateien zählen; Gas drückt die Kolbenstange heraus, und das { $verdict }
records-speaks-for-tension = spricht für Zugkraft positiv (Zugstufe)
records-speaks-for-push = spricht für Druckkraft positiv (Druckstufe)
records-too-small-to-tell = ist zu klein, um die Richtung zu zeigen
records-no-standstill = keine Umkehrpunkte im Stillstand, so dass die Gaskraft nicht zu erkennen ist
records-asymmetry = von langsam zu schnell wächst die Kraft bei positiver Geschwindigkeit { $ratio }-mal so stark wie bei negativer (bekannt auf einen Faktor { $error }); die meisten Dämpfer sind in der Zugstufe härter, und das { $verdict }
records-speaks-for-rebound = spricht für Zugstufe positiv
records-speaks-for-compression = spricht für Druckstufe positiv
records-tells-nothing = sagt nichts aus
records-contradict = Gaskraft und Unsymmetrie widersprechen sich; entschieden hat der deutlichere der beiden Hinweise
records-not-dissipating = kein Versuch nimmt deutlich Energie auf, so dass nicht sicher ist, ob Kraft und Bewegung zusammengehören
records-maybe-exchanged = Weg und Kraft sehen vertauscht aus, sodass nichts davon sicher ist
records-sign-unsure = dass die Dateien { $direction } positiv zählen, ist nur zu { $percent } % sicher: { $reasons }. Bitte angeben: { $option }, wenn das stimmt, sonst die andere Richtung
records-negative-gas = so gezählt zöge das Gas die Stange mit { $force } N hinein, was kein Gas tut: entweder ist die Richtung falsch (--positive), oder die Kraftmessdose hat einen Nullpunktfehler (--force-zero)
records-sign-of-rig = { $file }: für sich würde { $own } positiv gezählt (zu { $percent } % sicher); die sichersten Messungen des Prüfstands sprechen für { $other } positiv ({ $sure } %), daher wird auch hier so gezählt. Stammt sie von einem anderen Prüfstand, --positive angeben
records-signs-disagree = { $file }: zählt { $own } positiv (zu { $percent } % sicher), die Messungen, mit denen verglichen wird, zählen { $other } positiv ({ $sure } %); stammen sie von einem Prüfstand, ist eines falsch: --positive angeben
records-weak = die Hinweise sind schwach; mit --positive rebound oder --positive compression angeben, was gilt
records-turned-round = In Bewegung und Kraft zugleich umgedreht, passten { $tests } zu den anderen Versuchen, wie gelesen nicht: bei gleichen Geschwindigkeiten ist die Kraft mitten zwischen Zug und Druck in { $test } { $own } N, in den anderen { $usual } N. Prüfen, ob diese Dateien in anderer Richtung zählen, und den Export berichtigen oder sie mit --exclude weglassen
records-other-settings = { $first } hat bei gleicher Bewegung die { $times }-fache Kraft von { $second }: das sind mehrere Dämpfer oder mehrere Einstellungen eines Dämpfers (Klicks, Strom), und ein Modell kann sie nicht alle wiedergeben. Getrennt identifizieren (Ordner oder --exclude). { $belong }
records-several-settings = die Versuche wurden bei { $count } Einstellungen ({ $name }) gemessen, und ein Modell enthält nur eine davon: { $settings }. Sie mit dashpot fit --setting { $option } als einen Dämpfer über { $name } anpassen, oder jede für sich, die anderen mit --exclude weggelassen; dashpot diagnose --group vergleicht sie
records-not-one-damper = { $settings }. Um alle als einen Dämpfer ohne Einstellung anzupassen, --setting { $none } angeben
records-setting-at = { $value }: { $names }
records-setting-varies = am Dämpferventil ändert sich { $setting } im ganzen Versuch zwischen { $low } und { $high }
records-setting-changes = { $change }. dashpot fit --setting { $option } bestimmt daraus die Antwort des Ventils; ein Modell bei einer Einstellung kann ihm nicht folgen (--exclude)
records-setting-steps = am Dämpferventil springt { $setting } im Versuch { $count }-mal zwischen { $low } und { $high }
records-setting-name = der Name von { $test } nennt { $named }, und der Kanal { $setting } zeigt { $shown }: es gilt der Kanal (Versuche, bei denen Name und Kanal sich widersprechen: { $count }). Prüfen, was stimmt; sollen die Namen gelten, ihre Werte in campaign.toml unter settings eintragen
records-setting-typed = { $text } ist keine Einstellung: eine Zahl von -{ $largest } bis { $largest } mit Einheit angeben, etwa 0,8 A, 12 clicks oder 3 bar
records-setting-quantity = { $text } ist kein Wert der Einstellung { $setting }, die diese Versuche haben
records-setting-quantities = diese Versuche haben mehrere Einstellungen ({ $names }); die Einstellung eines Versuchs korrigieren, wo nur Versuche mit einer davon geöffnet sind
records-settings = Nach ihren Kräften gehören zusammen, von weich bis hart: { $settings }{ $open }
records-setting = { $number }) { $names }
records-setting-all = alle von '{ $name }' ({ $count })
records-setting-open = ; von { $names } sagt es die Kraft nicht
records-zero-off = Die Kraft von { $tests } liegt bei gleichen Geschwindigkeiten { $low } bis { $high } N neben der der anderen Versuche, in beiden Richtungen gleich: der Nullpunkt der Kraftmessdose hat sich verschoben, das Gas war wärmer, oder ein verstellbarer Dämpfer war anders eingestellt. Den Nullpunkt vor jedem Versuch setzen; Reibung und Gaskraft leiden darunter
records-given = { $direction } positiv war angegeben
records-against-given = { $direction } positiv war angegeben, aber die Daten sprechen für das Gegenteil: { $reasons }

## What reading says of records. What a campaign does without.

records-left-out = weggelassen: { $fault }
records-no-record = weggelassen, da keine Messung: { $fault }
records-first-and-more = { $first }; { $count } weitere
records-more-left-out = { $count ->
        [one] { $count } weitere Datei oder weiterer Versuch wurde
       *[other] { $count } weitere Dateien und Versuche wurden
    } weggelassen

## What reading says of records. Faults of files.

records-unknown-type = { $file }: ist keine Messung; Messungen sind Dateien { $kinds }
records-not-read = { $file }: ist { $is } und wird nicht gelesen; { $instead }
records-empty-file = { $file }: ist leer (0 Byte); neu exportieren
records-workbook = { $file }: lässt sich nicht als Arbeitsmappe lesen ({ $cause }); neu als .xlsx speichern oder das Blatt als CSV exportieren
records-rpc = { $file }: lässt sich nicht als RPC-III-Zeitverlauf lesen ({ $cause })
records-binary = { $file }: lässt sich nicht als { $kind } lesen ({ $cause })
records-mat = { $file }: lässt sich nicht als MAT-Datei lesen ({ $cause }); neu speichern mit save(..., '-v7')
records-no-header = { $at }: keine Kopfzeile gefunden, die Zeit und andere Kanäle nennt; die erste Zeile lautet „{ $found }“.{ $near }
records-best-line = { " " }Am besten verstanden wird Zeile { $line }, mit { $known }; eine Kopfzeile braucht zwei Spalten, die verstanden werden.
records-angle-alone = { " " }Die Spalte „{ $column }“ ist ein Kurbelwinkel. Er ergibt die Zeit, wenn eine Zeile über der Tabelle die Drehzahl angibt, etwa „Drehzahl: 6 1/min“. Der Weg wird nicht daraus berechnet: Exportieren Sie auch den Weg, in einer eigenen Spalte.
records-taken-for = „{ $column }“ für { $channel }
records-figures-alone = { " " }Sie enthält { $count ->
        [one] { $count } Spalte Zahlen
       *[other] { $count } Spalten Zahlen
    } ohne Überschriften: Sagen Sie alles auf einmal, welche was ist, mit ihren Nummern, und in welchen Einheiten, etwa { $options }.
records-no-data = { $at }: hat eine Kopfzeile, aber keine Zeilen mit Daten

## What reading says of records. What is wrong with what was asked for.

records-not-found = { $file }: es gibt keine solche Datei und keinen solchen Ordner; den Pfad prüfen
records-cannot-read = { $file }: lässt sich nicht lesen ({ $cause })
records-is-peak-table = { $file }: ist eine Tabelle von Spitzenwerten und keine Messung über der Zeit; dashpot import peaks { $file } -o damper.toml macht daraus ein Modell
records-not-regular = { $file }: ist keine gewöhnliche Datei, sondern eine Pipe, ein Gerät oder ein Ordner; den Inhalt als Datei speichern und diese nennen
records-too-large = { $file }: hat { $size }, gelesen werden Dateien bis { $largest }; in einzelne Versuche teilen oder mit weniger Kanälen oder geringerer Abtastrate speichern
records-too-costly = { $at }: wird entpackt größer, als eine Datei dieser Größe werden darf; als CSV neu speichern oder in einzelne Versuche teilen
records-too-many-columns = { $at }, Zeile { $line }: hat { $found } Spalten, mehr als die { $most }, die eine Messung haben darf; nur die nötigen speichern
records-empty-folder = { $folder }: enthält keine Messung; ein Ordner mit Messungen enthält { $kinds }
records-in-subfolders = { $folder }: enthält selbst keine Messung; { $count ->
        [one] { $count } Datei liegt
       *[other] { $count } Dateien liegen
    } in seinen Unterordnern: { $names }. Sind das Versuche an einem Dämpfer, so liest --subfolders sie als eine Messreihe; ist jeder ein eigener Dämpfer, einen davon nennen oder sie mit dashpot diagnose --group folders vergleichen
records-kinds = { $others } und { $last }
records-no-paths = keine Messung angegeben; eine Messdatei oder einen Ordner mit Messungen nennen
records-excludes-nothing = --exclude { $pattern } trifft keine Datei und keinen Versuch; die erste Datei heißt { $first }
records-excludes-all = --exclude lässt keine Messung übrig; { $count ->
        [one] die einzige Datei oder der einzige Versuch trifft
       *[other] alle { $count } Dateien und Versuche treffen
    } zu
records-profiles-disagree = { $first } und { $second } nennen verschiedene Richtungen positiv; beide angleichen oder --positive angeben
records-indispensable = { $channel } kann in Messungen nicht fehlen; bei --ignore wegnehmen
records-in-line = { $at }, Zeile { $line }: { $cause }

## What reading says of records. Headings and units.

records-understood = { $header } Verstanden werden: { $understood }. Andere Überschriften nennt --column force="Load Cell 1"
records-swapped = { $at }: die Überschriften „{ $first }“ und „{ $second }“ scheinen vertauscht: { $evidence }. Die Kopfzeile berichtigen oder --column { $of_first }="{ $second }" --column { $of_second }="{ $first }" angeben (und --unit, wo auch die Einheit vertauscht ist); sind sie richtig, darauf mit --unit { $of_first }=... bestehen
records-wrong-unit = { $evidence }; das spricht für { $likely }, als { $written } geschrieben. --unit { $channel }={ $likely } angeben, oder mit --unit { $channel }={ $written } darauf bestehen
records-files-unit = { $count } von { $all } Versuchen { $count ->
        [one] passt
       *[other] passen
    } nicht zu den anderen, und zwar so, wie es eine Einheit erklärt: { $tests }. { $test } zeigt ±{ $force } N bei { $velocity } mm/s, die anderen ±{ $usual } N bei { $there } mm/s; das spricht für { $likely }, als { $written } geschrieben.{ $either }{ $labels } Die Überschrift der falschen Dateien berichtigen, oder sie in einen eigenen Ordner legen, einmal dashpot import-profile ORDNER --unit { $channel }={ $first } aufrufen und beide Ordner nennen. Oder sie mit --exclude weglassen; oder mit --unit { $channel }={ $written } darauf bestehen, dass alle Dateien in { $written } sind
records-or-the-others = { " " }Sind diese richtig, so sind umgekehrt die anderen falsch: { $others }.
records-or-labels = { " " }Haben die Versuche mehrere Einstellungen, kann das auch an falschen Angaben liegen: diese zuerst prüfen.
records-labels-deviate = die Kräfte von { $count } der { $all } Versuche widersprechen den anderen Versuchen bei ihrer Angabe { $name } und passen zu denen bei einer anderen: { $groups }. { $advice }
records-label-group = { $tests } (Angabe { $stated }, Kräfte von { $fitting })
records-label-group-or-unit = { $group }, oder { $likely } als { $written } geschrieben
records-forces-unlike = die Kräfte von { $tests } weichen bei gleichen Geschwindigkeiten stärker von denen der anderen Versuche ab, als ein Dämpfer sie ändert ({ $test }: das { $factor }-Fache der anderen Versuche): Einheit, Verstärkung und Einstellung prüfen oder diese Versuche weglassen
records-labels-check = Die Angaben dieser Versuche prüfen; ein berichtigter Wert gehört in campaign.toml unter settings
records-labels-mirrored = Jeder von ihnen hat die Kraft von { $name } vom anderen Ende gezählt. Prüfen, von welchem Ende diese und die anderen Versuche zählen; berichtigte Werte gehören in campaign.toml unter settings
records-missing-column = { $at }, Zeile { $line }: keine Spalte für { $missing }; die Spalten sind { $found }.{ $near } Die Spalte mit --column { $example }="Überschrift" nennen{ $otherwise }{ $units }
records-units-too = . Auch Einheiten fehlen: Geben Sie sie an, wie die Datei sie hat, etwa { $options }
records-or-crank-speed = , oder die Drehzahl der Kurbel in einer Zeile über der Tabelle angeben, etwa ‚Drehzahl: 6 1/min‘; die Spalte ‚{ $column }‘ ergibt dann die Zeit
records-or-sample-rate = , oder, wo die Datei keine hat, --sample-rate 1000 angeben (Abtastwerte je Sekunde)
records-several-columns = { $at }, Zeile { $line }: mehrere Spalten könnten { $channel } sein: { $names }; eine mit --column { $channel }="{ $first }" wählen
records-no-such-column = { $at }, Zeile { $line }: es gibt keine Spalte „{ $wanted }“ für { $channel }; die Spalten sind { $found }.{ $near }
records-no-setting-column = kein Versuch hat eine Spalte „{ $wanted }“ für die Einstellung: die Überschrift prüfen, mit --column setting=HEADING oder in campaign.toml
records-meant = { " " }Ist „{ $near }“ gemeint?
records-missing-unit = { $at }, Zeile { $line }: die Spalte „{ $column }“ hat keine Einheit; sie als „{ $column } [{ $example }]“ in die Überschrift schreiben oder --unit { $channel }={ $example } angeben. Verstanden werden für { $channel }: { $understood }
records-missing-units = { $at }, Zeile { $line }: für { $columns } ist keine Einheit angegeben; sagen Sie sie, wie die Datei sie hat, etwa { $options }{ $in_heading }. Verstanden werden: { $understood }
records-or-in-heading = , oder schreiben Sie sie in jede Überschrift, etwa „Kraft [N]“
records-unknown-unit = { $at }, Zeile { $line }: die Spalte „{ $column }“ hat die Einheit „{ $unit }“, die für { $channel } nicht verstanden wird; verstanden werden { $understood }. Ist die Überschrift falsch, --unit { $channel }=... angeben

## What reading says of records. What speaks for swapped headings.

records-time-stands = die als Zeit gelesene Spalte springt in { $percent } % der Zeilen zurück oder steht, die als { $other } gelesene nie
records-spans = der Weg überstriche { $displacement } mm und die Kraft { $force } N
records-force-smoother = { $spans }, und die Kraft wäre die glattere von beiden
records-derivative-of-force = die Geschwindigkeit ist die Ableitung der als Kraft gelesenen Spalte (Korrelation { $with_force }), nicht der als Weg gelesenen ({ $with_displacement })
records-displacement-rougher = die als Weg gelesene Spalte ist { $times }-mal rauer als die als Kraft gelesene, und der Dämpfer gäbe Energie ab; { $spans }

## What reading says of records. What speaks for another unit.

records-too-quick = { $record } würde sich { $seconds } s lang um ±{ $amplitude } mm bei { $frequency } Hz bewegen
records-too-long = { $count ->
        [one] der einzige Versuch
       *[other] der schnellste von { $count } Versuchen
    } erreichte { $velocity } mm/s, der längste dauerte { $hours } h, mit einem Abtastwert alle { $step } s
records-too-stiff = kein Versuch bewegte sich um mehr als ±{ $amplitude } mm, und { $force } N bei { $velocity } mm/s wären eine Dämpfung von { $damping } N s/m
records-mixed-current = { $record }: der Strom des Dämpferventils erreichte { $current } A, in den anderen Versuchen höchstens { $others } A; das spricht für mA unter einer Überschrift in A. Die Überschrift dieser Datei berichtigen oder sie mit --exclude '{ $test }' weglassen; --unit current=A, wenn es dabei bleiben soll
records-too-much-current = der Strom des Dämpferventils erreichte { $current } A
records-too-weak = { $count ->
        [one] der einzige Versuch
       *[other] der stärkste von { $count } Versuchen
    } zeigte ±{ $strongest } N, und { $test } ±{ $force } N bei { $velocity } mm/s, eine Dämpfung von { $damping } N s/m

## What reading says of records. What no damper has.

records-absurd = { $record }: zeigt { $what }, was kein Fahrwerksdämpfer hat; { $advice }
records-an-amplitude = eine Amplitude von { $amplitude } m
records-a-velocity = eine Spitzengeschwindigkeit von { $velocity } mm/s
records-a-force = eine Kraft von { $force } N
records-say-mm = enthält die Datei mm, dies angeben: --unit displacement=mm, oder velocity=mm/s, wo integriert wird
records-check-motion-units = die Einheiten von Geschwindigkeit und Zeit prüfen: --unit velocity=mm/s, --unit time=s
records-no-more-force = eine Kraft von höchstens { $force } N
records-say-stronger = gibt die Datei eine andere Einheit an, bitte angeben: --unit force=kN
records-unit-was-given = die Einheit war angegeben, also ist es eine andere, oder Spalte, Faktor oder Sensor stimmen nicht: bitte prüfen, und --unit weglassen, wo die Überschrift die Einheit nennt
records-say-n = enthält die Datei N, dies angeben: --unit force=N

## What reading says of records. All tests of a campaign.

records-all-without-force = { $count } von { $all ->
        [one] { $all } Versuch
       *[other] { $all } Versuchen
    } { $count ->
        [one] zeigt
       *[other] zeigen
    } keine Kraft: in { $record } hebt sie sich nicht von ihrem Rauschen von { $noise } N ab, obwohl sich der Dämpfer bewegt. Kraftmessdose und Kanal prüfen (--column force="Überschrift")
records-feeds-energy = der Dämpfer gäbe Energie in den Prüfstand ab, also ist ein Vorzeichen falsch: { $cause }
records-few-feed = { $fewer } von { $count } Versuchen { $fewer ->
        [one] gibt
       *[other] geben
    } Energie ab, { $more ->
        [one] der andere
       *[other] die anderen { $more }
    } nicht: { $names }. { $apart }{ $also }
records-few-take = { $fewer } von { $count } Versuchen { $fewer ->
        [one] nimmt
       *[other] nehmen
    } Energie auf, { $more ->
        [one] der andere
       *[other] die anderen { $more }
    } nicht: { $names }. { $apart }{ $also }
records-apart = Diese Dateien zählen Kraft oder Bewegung in einer anderen Richtung als die übrigen. Sie getrennt laden, mit --flip force oder --flip motion für die, die Energie abgeben, oder den Export berichtigen
records-all-feed = in { $count ->
        [one] dem einzigen Versuch
       *[other] allen { $count } Versuchen
    } mit deutlicher Schleife wirkt die Kraft in Richtung der Bewegung (Korrelation { $correlation }), also sind Kraft und Bewegung entgegengesetzt gezählt; { $culprit }{ $also }
records-exchanged = Weg und Kraft sehen in { $count } von { $all ->
        [one] { $all } Versuch
       *[other] { $all } Versuchen
    } vertauscht aus: { $names }. In { $test } verläuft die als Kraft gelesene Spalte wie ein Sinus, wie ihn ein Prüfstand fährt (ihre Oberwellen betragen { $of_force } %), die als Weg gelesene nicht ({ $of_displacement } %)
records-exchanged-feed = { $exchanged }; so gelesen gäbe der Dämpfer Energie in den Prüfstand ab. Geben Sie --column displacement="Überschrift" und --column force="Überschrift" umgekehrt an, und --unit, wo die Einheiten mitgehen. Betrifft es nur einige Dateien, legen Sie diese in einen eigenen Ordner, sagen Sie es dort mit dashpot import-profile, und nennen Sie beide Ordner
records-exchanged-doubt = { $exchanged }. Wenn das so ist, stimmt nichts von dem, was folgt: Geben Sie --column displacement="Überschrift" und --column force="Überschrift" umgekehrt an, und lassen Sie --flip weg
records-or-late = . Oder { $late }; dann { $option } angeben
records-flip-motion = { $standstill }; dann zählen Weg und Geschwindigkeit in Druckrichtung positiv. --flip motion angeben (oder den Export berichtigen)
records-flip-force = { $standstill }; dann zählen Weg und Geschwindigkeit in Zugrichtung positiv. --flip force angeben (oder den Export berichtigen)
records-flip-either = { $standstill }. Sind Druckkräfte positiv gezählt, --flip force angeben, sind es Druckbewegungen, --flip motion (oder den Export berichtigen)

## What reading says of records. A motion to be imposed.

records-motion-beyond = { $at }, Zeile { $line }: { $channel } ist { $value }, eine Bewegung bleibt aber in ±{ $limit }; die Einheit der Spalte prüfen, die --unit nennt
records-motion-gap = { $at }, Zeile { $line }: { $channel } fehlt oder ist keine Zahl; eine Bewegung wird genommen, wie sie ist, also die Lücke füllen oder abschneiden
records-motion-time = { $at }, Zeile { $line }: die Zeit steigt nicht: auf { $from } s folgt { $to } s; eine Bewegung braucht steigende Zeit
records-short-motion = { $at }: hat eine Zeile; eine Bewegung braucht mindestens zwei
records-several-motions = { $file }: enthält mehrere Versuche, „{ $first }“ und „{ $second }“; eine Bewegung ist einer, also die Datei teilen

## What reading says of records. Faults of tests.

records-too-few = { $at }: hat nur { $samples ->
        [one] { $samples } brauchbaren Messwert
       *[other] { $samples } brauchbare Messwerte
    }; ein Versuch braucht mindestens { $needed }, also neu messen
records-missing = { $at }, Zeile { $line }: der Kanal { $channel } fehlt oder ist keine Zahl, hier und in insgesamt { $count } von { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    }; zu viele, um sie wegzulassen. Den Export reparieren{ $advice }
records-or-ignore = { " " }oder den Kanal mit --ignore { $channel } weglassen
records-time-backwards = { $at }, Zeile { $line }: die Zeit springt von { $from } s auf { $to } s zurück. Enthält die Datei mehrere Versuche hintereinander, die Spalte, die sie unterscheidet, „test“ nennen oder die Datei teilen; sonst den fremden Block herausschneiden
records-constant-time = { $at }: die Zeit läuft nicht, sie ist in jeder Zeile { $time } s; prüfen, ob die richtige Spalte als Zeit gelesen wird
records-frozen = { $at }, Zeilen { $first } bis { $last }: der Kanal { $channel } steht { $seconds } s lang bei { $value } { $unit }, während { $moving }; { $advice }
records-clipped = { $at }, zuerst in Zeile { $line }: der Kanal { $channel } ist in { $percent } % der Messwerte bei { $value } { $unit } abgeschnitten, so dass zu wenig Verlässliches bleibt; { $advice }
records-no-motion = { $at }: der Dämpfer bewegt sich nicht: der Kanal { $channel } zeigt nur Rauschen, innerhalb von { $range } { $unit }. Den Versuch neu messen oder, wenn er stehen soll, herausnehmen
records-constant-force = { $at }: die Kraft ist in jeder Zeile { $value } N, während der Dämpfer sich bewegt; Kraftmessdose und Kabel prüfen und neu messen
records-cell = { $at }, Zeile { $line }, Spalte „{ $column }“: „{ $text }“ ist keine Zahl{ $hint }
records-fields = { $at }, Zeile { $line }: hat { $found ->
        [one] { $found } Feld
       *[other] { $found } Felder
    }, wo die Kopfzeile { $expected } hat{ $hint }
records-contradiction = { $at }: Weg und Geschwindigkeit widersprechen sich: { $cause }

## What reading says of records. What moves while a channel is frozen, and what to do.

records-damper-moves = der Dämpfer sich bewegt
records-velocity-moves = er sich nach der Geschwindigkeit bewegt
records-force-changes = die Kraft sich ändert
records-displacement-changes = der Weg sich ändert
records-check-cell = Kraftmessdose und Kabel prüfen und diese Zeilen herausschneiden oder neu messen
records-read-displacement-only = diese Zeilen herausschneiden oder nur den Weg lesen: --ignore velocity
records-read-velocity-only = diese Zeilen herausschneiden oder nur die Geschwindigkeit lesen: --ignore displacement
records-cut-or-measure = diese Zeilen herausschneiden oder neu messen

## What reading says of records. What to do about a clipped channel.

records-no-other-motion = es gibt keinen anderen Kanal der Bewegung; mit größerem Messbereich neu messen
records-larger-range = mit größerem Messbereich der Kraftmessdose oder ihres Verstärkers neu messen

## What reading says of records. Why a cell or a row may be wrong.

records-without-separators = ; ohne Tausendertrennzeichen schreiben
records-format-as-numbers = ; die Zellen als Zahlen formatieren
records-quote-decimal-commas = ; Dezimalkommas brauchen Anführungszeichen um die Zellen oder ein Semikolon oder einen Tabulator zwischen den Spalten

## What reading says of records. How displacement and velocity contradict each other.

records-velocity-late = „{ $column }“ kommt { $lag } ms { $side } der Ableitung des Wegs, wie nach einem Filter; die Spalte wurde nicht verwendet, die Geschwindigkeit stammt aus dem Weg
records-behind = hinter
records-ahead = vor
records-other-motion = das Integral der Geschwindigkeit erklärt nur { $percent } % des Wegs; sie gehören nicht zu einer Bewegung. Prüfen, ob die richtigen Spalten gelesen werden (--column velocity="heading"), { $advice }
records-opposite-signs = sie haben entgegengesetzte Vorzeichen (die Geschwindigkeit ist das { $gain }-Fache der Ableitung des Wegs). Eines davon im Export umdrehen, { $advice }
records-unit-slip = die Geschwindigkeit ist das { $gain }-Fache der Ableitung des Wegs: eine falsche Einheit. Am wahrscheinlichsten { $likely }{ $others }
records-unit-candidate = hat der Kanal { $channel } die Einheit { $likely }, gelesen wurde { $read }; das ergibt einen Versuch von { $amplitude } mm bei { $frequency } Hz und { $velocity } mm/s: { $option } angeben
records-otherwise = . Andernfalls { $others }
records-or-else = {"; oder "}
records-other-scale = die Geschwindigkeit ist das { $gain }-Fache der Ableitung des Wegs. Einheiten und Kalibrierung beider prüfen, die Einheit der Zeit, und ob die Abtastung für die Bewegung schnell genug ist, { $advice }
records-read-one-only = oder nur eines davon lesen: --ignore velocity (oder --ignore displacement)

## What reading says of records. Channels.

records-channel-time = Zeit
records-channel-displacement = Weg
records-channel-velocity = Geschwindigkeit
records-channel-force = Kraft
records-channel-side-force = Seitenkraft
records-channel-temperature = Temperatur
records-channel-current = Strom
records-channel-setting = Einstellung

## What reading says of records. Files in formats that are not read, and what to do.

records-famos = eine Datei von imc FAMOS
records-old-workbook = eine Arbeitsmappe von Excel 97 bis 2003 (.xls) oder ein Dokument aus dieser Zeit
records-open-document = eine OpenDocument-Datei
records-diadem-heading = der Kopf eines DIAdem-Datensatzes, dessen Zahlen in anderen Dateien liegen
records-diadem = ein DIAdem-Datensatz
records-hdf5 = eine HDF5-Datei
records-database = eine Datenbank
records-zip = ein Zip-Archiv
records-gzip = eine gepackte Datei (gzip)
records-pdf = ein PDF
records-xml = eine XML-Datei
records-catman = eine Binärdatei von catman
records-export-from-imc = aus imc FAMOS oder imc STUDIO als CSV, MDF 4 oder TDMS exportieren
records-save-as-xlsx = als .xlsx speichern
records-save-as-tdms = in DIAdem als TDMS speichern
records-save-channels = die Kanäle als CSV oder als MAT-Datei speichern
records-export-as-csv = den Versuch als CSV exportieren
records-unpack-folder = entpacken und den Ordner nennen
records-unpack = entpacken
records-export-from-catman = aus catman als ASCII, MDF 4 oder MAT exportieren

# What a fit says.

## What a fit says. Lists.

identification-comma = ,{ " " }
identification-semicolon = ;{ " " }
identification-that = , dass{ " " }

## What a fit says. Which tests a number was identified from.

identification-share-of = { $tests } { $percent } %
identification-no-test = kein Versuch zeigt es

## What a fit says. The inventory.

identification-carries = { $effect }: { $force } N effektiv, { $share } der Kraft; Wahrscheinlichkeit { $probability }
identification-carries-in-form = { $effect } ({ $form }): { $force } N effektiv, { $share } der Kraft; Wahrscheinlichkeit { $probability }

## What a fit says. What the data does not determine.

identification-not-identified = { $name } ließ sich aus diesen Daten nicht identifizieren ({ $why }); das Element ist aus
identification-needs-side-forces = dazu braucht es langsame Versuche bei zwei oder mehr Seitenkräften, mit einem Kanal der Seitenkraft
identification-taken-up = eine freie FV-Kurve nimmt einen v²-Anteil auf
identification-held = { $name } ließ sich aus diesen Daten nicht identifizieren; der Wert ist auf { $value } gehalten
identification-at-bound = { $name } stieß bei { $value } an die Grenze seines Bereichs: die Daten verlangen etwas, was dieses Element nicht kann
identification-rare-value = { $name } ist { $value }, außerhalb dessen, was Dämpfer dieser Kraft und Prüfstände zeigen ({ $low } bis { $high }): der Wert gleicht vielleicht aus, was dem Modell fehlt
identification-rare-assumed = { $name } ist mit { $value } angenommen, außerhalb dessen, was Dämpfer dieser Kraft und Prüfstände zeigen ({ $low } bis { $high }): der Wert gleicht vielleicht aus, was dem Modell fehlt

## What a fit says. What was known of the damper beside its records.

identification-expected = { $name } wurde nach den Maßen des Dämpfers ({ $facts }) bei { $value } { $unit } erwartet (95 %: { $low } bis { $high })
identification-contradicts = { $name } widerspricht den Maßen des Dämpfers: { $value } { $unit } sind das { $ratio }-Fache der { $expected } { $unit }, die aus { $facts } folgen

## What a fit says. What the campaign cannot show.

identification-one-rate = alle Versuche kehren fast gleich schnell um, so dass ein später Kraftkanal und ein weicher Reihenpfad gleich aussehen: der Kanal gilt als unverzögert; derselbe Hub bei einem Drittel der Frequenz würde sie unterscheiden
identification-one-test = in einem einzigen Versuch sehen ein später Kraftkanal und ein weicher Reihenpfad gleich aus: der Kanal gilt als unverzögert; derselbe Hub bei einem Drittel der Frequenz würde sie unterscheiden
identification-roads = { $roads ->
        [one] { $roads } langer Versuch ohne Zyklen wird
       *[other] { $roads } lange Versuche ohne Zyklen werden
    } in { $stretches ->
        [one] { $stretches } Abschnitt
       *[other] { $stretches } Abschnitten
    } von je { $seconds } s gerechnet, die jeden ihrer Wege und jede ihrer Geschwindigkeiten berühren; Fehler über ganze Aufzeichnungen zählen jeden Messpunkt
identification-selected = die Messreihe hat { $all } Versuche, mehr als eine Suche nutzen kann: { $selected } davon stehen für alle, aus jeder Amplitude, Geschwindigkeit, Mittellage, Temperatur und Seitenkraft, über die ganze Reihe verteilt. Fehler über ganze Aufzeichnungen zählen alle Versuche; um selbst zu wählen, --exclude oder einen kleineren Ordner angeben
identification-no-slow-test = es gibt keinen langsamen Versuch mit ganzen Zyklen (Spitze unter { $velocity } mm/s): die Reibung kommt aus den langsamen Teilen schnellerer Versuche
identification-no-slow-test-no-friction = es gibt keinen langsamen Versuch mit ganzen Zyklen (Spitze unter { $velocity } mm/s): ein solcher zeigt Reibung am besten, und das Modell hat keine
identification-one-amplitude = alle Versuche haben fast dieselbe Amplitude: Feder und Reihensteifigkeit beruhen allein auf der Frequenz
identification-one-amplitude-of-spring = alle Versuche haben fast dieselbe Amplitude: die Feder beruht allein auf der Frequenz
identification-one-amplitude-of-series = alle Versuche haben fast dieselbe Amplitude: die Reihensteifigkeit beruht allein auf der Frequenz
identification-one-fast-amplitude = alle Versuche über { $velocity } mm/s haben fast dieselbe Amplitude: Die Reihensteifigkeit beruht allein auf der Frequenz
identification-zero-moves = das Modell lässt von jedem Versuch eine andere gleichbleibende Kraft übrig, von { $low } bis { $high } N: der Nullpunkt des Kraftkanals wandert von Versuch zu Versuch, oder das Gas erwärmt sich. Vor jedem Versuch nullen oder mit einer durchlaufenden Uhr messen, mit der eine Drift gefunden wird; Reibung und Gaskraft sind nicht verlässlich

## What a fit says. What the measurement is off by.

identification-found-early = der Kraftkanal kommt { $value } ms zu früh (95 %: { $low } bis { $high })
identification-found-delay = der Kraftkanal ist gegenüber der Bewegung um { $value } ms verzögert (95 %: { $low } bis { $high })
identification-found-mass = die Kraftmessdose bewegt eine eigene Masse von { $value } kg (95 %: { $low } bis { $high })
identification-found-gain-drift = die Verstärkung des Kraftkanals wandert um { $value } % je Minute (95 %: { $low } bis { $high })
identification-found-drift = der Nullpunkt des Kraftkanals wandert um { $value } N je Minute (95 %: { $low } bis { $high })
identification-or-warm-gas = nicht in allen Versuchen wurde eine Temperatur aufgezeichnet: Gas, das sich während der Messreihe erwärmt, lässt die Kraft in Ruhe ebenso fallen. Die Temperatur trennt beides
identification-gas-at = gas_force gilt bei { $temperature } °C, der Mitte der gemessenen Temperaturen; mit gas_warming_rate wächst sie mit ihnen
identification-doubtful-error = { $effect } hat nur eine Wahrscheinlichkeit von { $probability }: Ein Effekt des Dämpfers, den eine Anpassung nicht versucht, etwa Luft im Öl, kann so aussehen. dashpot diagnose versucht alle Effekte
identification-taken-out-here = { $finding }: hier herausgerechnet, nicht im Modell; validate und diagnose rechnen es aus diesen Messungen ebenfalls heraus{ $option }
identification-give-option = ; für andere Messungen dieses Prüfstands { $option } angeben oder in ihre campaign.toml schreiben
identification-taken-out-as-the-fit-did = aus den Messungen herausgerechnet, wie bei der Identifikation des Modells: { $findings }
identification-found-in-its-own = die Identifikation des Modells fand in ihren eigenen Messungen: { $findings }; dies sind andere Messungen, und aus ihnen wurde nichts herausgerechnet{ $option }
identification-if-the-same-rig = : hat derselbe Prüfstand diese gemessen, { $options } angeben

## What a fit says. What a model file holds that does nothing.

identification-idle = die Modelldatei gibt { $names } an, aber das Element { $element } ist aus, sodass dies nichts bewirkt; um es zu nutzen, in elements aufnehmen

## What a fit says. Numbers that a model file does not give, and numbers that are not those of its fit.

identification-family-worse = die Familie weicht { $ratio }-mal so weit ab wie eine Identifikation dieser Einstellung allein: Eine Zahl, die alle teilen, mag hier eine andere sein, manche dieser Versuche tragen vielleicht die Angabe einer anderen Einstellung, oder sie sind zu wenige, um einen Unterschied zu zeigen
identification-alone-worse = ein Fit dieser Einstellung allein weicht { $ratio }-mal so weit ab wie die Familie, seine Suche endete also bei einer schlechteren Struktur: das Verhältnis dazu sagt nichts
identification-on-defaults = das Element { $element } ist an, aber die Modelldatei gibt { $names } nicht an: Es gelten die Vorgaben aus docs/parameters.md
identification-edited = { $names }: außerhalb des 95-%-Intervalls, das die Identifikation in der Modelldatei hinterließ, also seither geändert; was die Identifikation dazu wusste, entfällt

## What a fit says. How far a fit is.

identification-preparing = Messungen werden vorbereitet
identification-plain-curve = einfache FV-Kurve
identification-first-fit = erste Anpassung von mehreren Startwerten aus
identification-choosing-structure = Reibung, Federn, Reihenpfad und Messfehler werden verglichen
identification-refining = alles gemeinsam verfeinern
identification-piecewise = stückweise lineare Kurve
identification-with-lag = Polynom mit Verzögerung
identification-done = fertig

## What a fit says. A damper over a setting.

identification-family-each = jede Einstellung für sich
identification-family-joint = alle Einstellungen zusammen: was ihnen gemeinsam ist und was von ihnen abhängt
identification-family-left-out = jede Einstellung aus den anderen vorhergesagt
identification-family-actuator = Antwort des Ventils aus Versuchen mit veränderlicher Einstellung
identification-changing-setting = Versuche mit veränderlicher Einstellung
identification-no-actuator = { $count ->
        [one] der Versuch
       *[other] die { $count } Versuche
    } mit veränderlicher Einstellung ({ $setting }) { $count ->
        [one] zeigt
       *[other] zeigen
    } keinen Steller: die Kraft folgt dem Befehl innerhalb von Abtastung und Rauschen
identification-actuator-open = die Messungen bestimmen { $names } nicht: die Werte sind solche, wie Ventile sie meist zeigen
identification-actuator-vague = die Versuche lassen { $names } um mehr als { $width } ms unsicher. Sprünge von { $setting } nach oben und unten zwischen mehreren Paaren von Einstellungen bei schneller Bewegung ergänzen
identification-actuator-two-settings = die Zeiten des Ventils setzen voraus, dass die Kraft zwischen { $low } und { $high } linear von { $setting } abhängt: eine gekrümmte Kraft verfälscht sie über ihre Intervalle hinaus. Eine Einstellung dazwischen messen
identification-family-selected = die Messreihe hat { $all } Versuche, mehr als eine Suche nutzen kann: { $selected } davon stehen für alle, höchstens { $most } je Einstellung und { $changing } mit wechselnder Einstellung, aus jeder Amplitude, Geschwindigkeit, Mittellage, Temperatur und Seitenkraft. Fehler über ganze Aufzeichnungen zählen alle Versuche; um selbst zu wählen, --exclude oder einen kleineren Ordner angeben
identification-no-interval-between = { $names }: hier, zwischen zwei Einstellungen, kein Intervall; erst drei oder mehr Einstellungen zeigen, wie weit die Interpolation abweicht
identification-label-suspect = { $test } gibt { $name } { $stated } an, doch seine Kräfte sind die von { $fitting }: bei der angegebenen Einstellung verfehlt das Modell ihn um das { $ratio }-Fache. Die Angabe prüfen; ein berichtigter Wert gehört in campaign.toml unter settings
identification-label-stray = { $test } gibt { $name } { $stated } an, doch seine Kräfte sind die von { $fitting } und nicht die der benachbarten Einstellungen. Die Angabe prüfen; ein berichtigter Wert gehört in campaign.toml unter settings
identification-setting-doubt = die Kräfte von { $test } sind etwa die von { $fitting }, nicht die von { $stated }: dort verfehlt das Modell sie um { $fitting_error } N, hier um { $stated_error } N. Die Einstellung des Versuchs und ihre Einheit prüfen
identification-labels-exchanged = die Dämpfkraft steigt oder fällt über { $name } nicht durchgehend; mit { $one } und { $other } vertauscht täte sie es. Die Angaben dieser Versuche prüfen; ein Dämpfer, der wirklich so ist, wird wie gemessen modelliert
identification-labels-opposed = über { $name } steigt die Dämpfkraft in { $direction } nahe { $rising } mm/s und fällt nahe { $falling } mm/s. Vielleicht zählen manche Versuche { $name } vom anderen Ende: ihre Angaben prüfen; ein Dämpfer, der wirklich so ist, wird wie gemessen modelliert
identification-family-stores = eine Änderung von { $setting } kann am Fahrzeug Arbeit leisten, denn sie ändert gespeicherte Energie oder eine Kraft in Ruhe: { $sources }
identification-energy-of-number = { $name } { $range }
identification-energy-at-rest = die Kraft der FV-Kurve bei Geschwindigkeit null, { $range }
identification-energy-of-lag = die nacheilende Kraft von { $element }
identification-energy-range = { $low } bei { $low_at } bis { $high } bei { $high_at }
identification-family-no-setting = kein Versuch nennt { $name }. In die Namen aller Versuche schreiben (800mA, 12clicks, 150psi), die Spalte angeben (--column setting=HEADING), die Einheit einer Stromspalte ohne Einheit nennen (--unit current=A), oder setting und [settings] in campaign.toml daneben eintragen{ $unread }
identification-family-unread = ; { $note }
identification-family-other-setting = kein Versuch nennt { $name }; die Versuche haben eine Einstellung namens { $known }: --setting mit diesem Namen angeben
identification-family-without = { $name } fehlt bei { $tests } (Versuche: { $count }). Mit --exclude weglassen, ihre Spalte nennen (--column setting=HEADING), oder in campaign.toml unter settings angeben{ $unread }
identification-family-one = alle Versuche bei konstantem Wert von { $name } haben denselben, { $value }: ein Modell darüber braucht mindestens zwei. Ohne --setting anpassen, oder die Einheit der Spalte prüfen
identification-family-only-changing = { $name } ändert sich in { $count ->
        [one] dem einzigen Versuch
       *[other] allen { $count } Versuchen
    }: ein Dämpfer darüber wird an Versuche bei zwei oder mehr festen Einstellungen angepasst; veränderliche bestimmen sein Ventil
identification-family-too-many = die Versuche haben { $count } Werte von { $name }, und ein Modell fasst { $most }: einige mit --exclude oder --hold-out weglassen, oder in campaign.toml unter [settings] angeben, was eingestellt war
identification-family-at = bei { $name } = { $value }: { $why }
identification-family-kernel = die Einstellungen ergeben kein Modell: { $parameter } { $why }
identification-family-not-finite = für alle Einstellungen zusammen ließ sich keine endliche Kraft berechnen; jede für sich anpassen, um den Versuch zu finden

## What a fit says. Why there is no fit.

identification-no-tests = es gibt keinen Versuch zum Anpassen: einen Ordner oder Dateien mit mindestens einer Messung angeben
identification-unknown-element = es gibt kein Element { $name }; die Elemente sind { $known }
identification-not-fitted = fit identifiziert { $name } nicht: dashpot diagnose fügt es einem angepassten Modell hinzu, wo es gefunden wird, oder man tut es von Hand; fit kennt { $known }
identification-other-family = { $name } ist ein eigenes Modell und nimmt kein anderes Element auf; --model lag verwenden
identification-one-sided = die Versuche bewegen sich nie in Richtung { $direction }: eine Kraft-Geschwindigkeits-Kurve braucht beide Richtungen
identification-not-finite = für den Versuch { $test } ließ sich keine endliche Kraft berechnen; seine Kanäle ansehen (ein Sprung im Weg?)

# What a diagnosis says.

## What a diagnosis says. How far a diagnosis is.

diagnosis-preparing = Messungen werden vorbereitet
diagnosis-fitting-reference = das Modell wird an die Referenz angepasst
diagnosis-refitting = das Modell wird, wie es ist, neu angepasst
diagnosis-each-effect = alles wird mit jedem Effekt neu angepasst
diagnosis-weighing = jeder Name wird neben den anderen gewogen
diagnosis-what-is-left = Blick auf das, was übrig bleibt
diagnosis-done = fertig

## What a diagnosis says. Why there is no diagnosis.

diagnosis-no-tests = es gibt keinen Versuch zur Diagnose: einen Ordner oder Dateien mit mindestens einer Messung angeben und nicht alle weglassen
diagnosis-unknown-name = es gibt keinen Effekt { $name }; die Effekte sind { $known }
diagnosis-nothing-to-compare = die Referenzmessreihe hat keinen der Versuche dieser Messreihe (Amplitude, Frequenz, Mittellage und Seitenkraft auf 5 % gleich): an beiden Dämpfern dieselbe Prüfmatrix fahren{ $turned }
diagnosis-besides = ; { $said }
diagnosis-opposite = die Messreihe wurde so gelesen, dass sie { $own } positiv zählt, die Referenz so, dass sie { $good } positiv zählt; wenn beide von einem Prüfstand kommen, beide mit --positive rebound oder beide mit --positive compression lesen
diagnosis-identical = dieselben Messungen stehen Wert für Wert in der Referenz: { $tests }; an ihnen kann sich nichts geändert haben, also prüfen, ob die Referenz der richtige Ordner ist
diagnosis-not-finite = das Modell gibt für diese Messungen keine endliche Kraft: dashpot validate zeigt, wo

## What a diagnosis says. Lists.

diagnosis-comma = ,{ " " }
diagnosis-and = { " " }und{ " " }

## What a diagnosis says. The answer.

diagnosis-times = das { $times }-Fache des Fehlers, den Rauschen und Form der Kurven übrig lassen
diagnosis-name-and-sure = { $effect } ({ $percent } sicher{ $instead })
diagnosis-instead-of = , anstelle von { $effect }
diagnosis-has-effect = dieser Dämpfer zeigt { $names }; { $residual }, { $rest }{ $also }
diagnosis-residual-falls = das Residuum fällt vom { $before }- auf das { $after }-Fache von Rauschen und Kurvenfehler
diagnosis-residual-stays = das Residuum fällt nicht (vorher das { $before }-Fache, danach das { $after }-Fache von Rauschen und Kurvenfehler)
diagnosis-leaves-nothing = was nichts unerklärt lässt
diagnosis-leaves-a-part = was einen Teil unerklärt lässt
diagnosis-new-effect = neu an diesem Dämpfer: { $names }; { $residual }, { $rest }{ $also }
diagnosis-also-changed = ; ebenfalls geändert: { $changes }
diagnosis-at-all-settings = bei jeder Einstellung zeigt dieser Dämpfer { $effect } ({ $sure } sicher{ $instead })
diagnosis-at-some-settings = { $effect } ({ $sure } sicher{ $instead }) fehlt im Modell bei { $names }; bei den anderen Einstellungen wird es nicht genannt
diagnosis-only-together = keine Einstellung allein braucht { $effects }; eine Einstellung sagt weniger als alle zusammen, darum entscheidet die Anpassung über alle (dashpot fit --setting), ob das Modell den Effekt behält
diagnosis-at-no-setting = bei keiner Einstellung fehlt dem Modell ein Effekt, den diese Aufzeichnungen benennen können
diagnosis-changed-at-all-settings = { $name } hat sich bei jeder Einstellung geändert ({ $sure } sicher)
diagnosis-changed-at-some-settings = { $name } hat sich bei { $names } geändert ({ $sure } sicher); bei den anderen Einstellungen zeigt sich keine Änderung davon
diagnosis-changed-at-no-setting = bei keiner Einstellung hat sich etwas geändert, das diese Messungen benennen können
diagnosis-settings-not-in-model = das Modell wurde bei { $names } nicht gemessen: seine Werte sind dort interpoliert, und die Diagnose passt sie zuerst an diese Messungen an. Sie beurteilt also nicht die Interpolation; das tut dashpot validate
diagnosis-no-name-at-all-settings = bei jeder Einstellung fehlt etwas, das noch keinen Namen hat
diagnosis-no-name-at-some-settings = bei { $names } fehlt etwas, das noch keinen Namen hat
diagnosis-needless = keiner der untersuchten Effekte fehlt; diese Messungen brauchen nicht: { $effects }
diagnosis-not-explained = { $percent } der Abweichung sind durch das Benannte nicht erklärt: eine andere Form davon oder etwas anderes
diagnosis-immaterial = das verbesserte Modell hat außerdem { $effects }, nicht benannt: in keinem Versuch übersteigt die Kraft das Rauschen und 0,5 % der gemessenen Kraft
diagnosis-test-and-times = { $test } ({ $times }-fach)
diagnosis-detection-limit = das Modell verfehlt die gemittelten Zyklen um { $residual } N effektiv, ihr Rauschen ist { $noise } N: der Unterschied gilt als Form der FV-Kurve, und ein Effekt dieser Größe ist davon nicht zu unterscheiden
diagnosis-still-missed = zu selten oder zu klein, um benannt zu werden, aber diese Versuche werden verfehlt: { $tests }
diagnosis-nothing-missing = es fehlt kein bekannter Effekt, den diese Messungen zeigen können: die Abweichung des Modells ist { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-none-of-asked = keiner der gefragten Effekte ({ $effects }) fehlt, soweit diese Messungen es zeigen können: die Abweichung des Modells ist { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-unchanged = es hat sich nichts geändert, was diese Messungen zeigen können: die Abweichung des Modells der Referenz ist { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-unchanged-of-asked = keine Zahl hat sich geändert, und keiner der gefragten Effekte ({ $effects }) ist neu, soweit diese Messungen es zeigen können: die Abweichung des Modells der Referenz ist { $times }{ $rest }{ $likeliest }{ $not_seen }{ $not_confirmed }
diagnosis-without-cause = ; { $percent } des mittleren quadratischen Fehlers haben keine bekannte Ursache
diagnosis-likeliest = ; am wahrscheinlichsten von den Effekten außerhalb des Modells ist { $effect } ({ $percent } sicher)
diagnosis-warmer = Versuche waren bis zu { $kelvin } K { $sense } als am Referenzdämpfer ({ $test }: { $here } und { $there } °C im Mittel): die Gaskraft wächst um 0,34 % je Kelvin, und warmes Öl dämpft weniger, sodass ein Teil des Unterschieds von der Temperatur kommen kann, vor allem eine Drift des Kraftnullpunkts; vergleichen Sie Messreihen gleicher Temperatur
diagnosis-warmer-sense = wärmer
diagnosis-colder-sense = kälter
diagnosis-changed = { $numbers }{ $more }
diagnosis-nothing-else = ; sonst hat sich nichts geändert
diagnosis-nothing-else-large = ; sonst hat sich nichts um mehr als 0,5 % der Kraft geändert
diagnosis-more-may-have-changed = ; es kann sich mehr geändert haben, denn die Abweichung des Modells ist noch { $times }
diagnosis-changed-both = Dämpfkraft { $percent } % in Zug- und Druckstufe ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-changed-rebound = Kraft der Zugstufe { $percent } % bei allen Geschwindigkeiten ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-changed-compression = Kraft der Druckstufe { $percent } % bei allen Geschwindigkeiten ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-changed-rebound-low = Kraft der Zugstufe bei kleiner Geschwindigkeit { $percent } % ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-changed-compression-low = Kraft der Druckstufe bei kleiner Geschwindigkeit { $percent } % ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-changed-rebound-high = Kraft der Zugstufe bei hoher Geschwindigkeit { $percent } % ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-changed-compression-high = Kraft der Druckstufe bei hoher Geschwindigkeit { $percent } % ({ $reference } → { $value } N bei { $velocity } mm/s)
diagnosis-other-number = { $name } { $reference } → { $value }
diagnosis-uncertain-change = { $change } (unsicher: das 95-%-Intervall, { $low } bis { $high } { $unit }, enthält die Referenz)
diagnosis-more-numbers = { " " }und { $count } weitere
diagnosis-cannot-show = ; nicht zeigen können sie { $effects }
diagnosis-not-confirmed = ; kein Versuch wurde zurückgehalten, um es zu bestätigen
diagnosis-cannot-tell = etwas fehlt: die Abweichung des Modells ist { $times }, und { $why }
diagnosis-too-few-tests = { $effect } ist am wahrscheinlichsten, aber zu wenige Versuche sprechen dafür, um es zu benennen
diagnosis-not-apart = diese Messungen können { $effects } nicht unterscheiden
diagnosis-unknown-effect = die Abweichung des Modells ist { $times }, und keiner der bekannten Effekte ist wahrscheinlich genug, um das zu erklären{ $nearest }
diagnosis-looks-like = ; es sieht aus wie { $what }
diagnosis-nearest = ; der nächstliegende, { $effect }, erklärt { $percent }
diagnosis-explains = erklärt { $percent } der Abweichung

## What a diagnosis says. What a disagreement without a name looks like.

diagnosis-like-guides = Reibung, die mit der Kraft wächst, wie sie eine schief stehende Traverse oder ein schiefes Auge in den Führungen erzeugt
diagnosis-like-load-cell = eine Schleife über der Kraft bei jeder Geschwindigkeit, wie sie eine Kraftmessdose mit Hysterese zeichnet
diagnosis-like-resonance = eine Resonanz im Kraftfluss, wie die eines Rahmens oder von Öl in einem Schlauch

## What a diagnosis says. Regions.

diagnosis-region = { $direction }, { $slow }–{ $fast } mm/s{ $phase }, { $place }: { $missing } (effektiv { $rms } N, Rauschen { $noise } N)
diagnosis-rebound = Zugstufe
diagnosis-compression = Druckstufe
diagnosis-speeding-up = { " " }beim Schnellerwerden
diagnosis-slowing-down = { " " }beim Langsamerwerden
diagnosis-in-all-tests = in allen Versuchen, die dorthin kommen
diagnosis-in-test = im Versuch { $test }
diagnosis-more-tensile = die gemessene Kraft liegt um { $mean } ± { $error } N weiter in Zugrichtung als die berechnete
diagnosis-more-compressive = die gemessene Kraft liegt um { $mean } ± { $error } N weiter in Druckrichtung als die berechnete
diagnosis-off-both-ways = die gemessene Kraft liegt über und unter der gerechneten

## What a diagnosis says. Tests that would tell more.

diagnosis-run-sine = einen Sinus von { $amplitude } { $unit } mit { $frequency } Hz{ $about }{ $under } fahren: { $a } und { $b } unterscheiden sich dort um { $difference } N effektiv
diagnosis-about-mean = { " " }um { $mean } { $unit }, wie die Dateien zählen,
diagnosis-under-side-force = { " " }unter { $force } N Seitenkraft
diagnosis-shows-best = so zeigt sich { $effect } am besten: { $remedy }
diagnosis-no-trace = in üblicher Stärke hinterließe es in diesen Versuchen keine Spur: { $remedy }
diagnosis-sum-alone = das Rohr weitet sich mit dem Druck, wie die Ölsäule nachgibt: ein Prüfstand zeigt nur die Summe beider, für die die Nachgiebigkeit des Öls (oil_compressibility) steht

## What a diagnosis says. The test that shows an effect best.

diagnosis-show-more = mehr Amplituden und Frequenzen
diagnosis-show-slow = langsame Dreiecke mit { $slow } bis { $fast } { $speed_unit }, zwei Hübe, zwei Temperaturen
diagnosis-show-spring = den ganzen Hub langsam durchfahren und einmal mit 1 Hz, in zwei Mittellagen
diagnosis-show-gas-warming = die Kraft in Ruhe in Hubmitte, kalt und nach starker Belastung, mit aufgezeichneter Temperatur
diagnosis-show-mount = Sinus von { $small } bis { $large } { $unit } bei { $low } bis { $high } Hz
diagnosis-show-zero = die Kraft in Ruhe ablesen, mit und ohne eingehängten Dämpfer
diagnosis-show-presliding = Hübe von { $small } bis { $large } { $unit } mit { $low } und { $high } Hz: gleiche Schleifen sprechen dafür
diagnosis-show-side-force = derselbe Sinus bei 0, { $half } und { $full } N Seitenkraft
diagnosis-show-oil = eine Spitzengeschwindigkeit bei mehreren Hüben und Frequenzen, in zwei Mittellagen
diagnosis-show-aeration = ein Versuch nach einer Nacht Ruhe und nach 200 Zyklen
diagnosis-show-cavitation = eine Spitzengeschwindigkeit bei mehreren Hüben, mit erhöhtem Gasdruck
diagnosis-show-fade = ein Referenzversuch kalt und heiß wiederholt, in gemischter Reihenfolge, mit aufgezeichneter Temperatur
diagnosis-show-position = Sinus von { $small } bis { $large } { $unit } in fünf oder mehr Mittellagen
diagnosis-show-bump-stop = langsam in den Anschlag drücken, in Richtung { $lowest } { $unit }, wie die Dateien zählen, dann mit zwei Geschwindigkeiten
diagnosis-show-rebound-stop = langsam in den Anschlag ziehen, in Richtung { $highest } { $unit }, wie die Dateien zählen, dann mit zwei Geschwindigkeiten
diagnosis-show-free-play = kleine Hübe mit einer Vorlast, die die Kraft nicht durch null gehen lässt, und ohne
diagnosis-show-frequency = eine Spitzengeschwindigkeit bei fünf Frequenzen von { $low } bis { $high } Hz
diagnosis-show-valve = langsame Geschwindigkeitsrampen durch den Knick, auf und ab
diagnosis-show-mass = den Prüfstand ohne den Dämpfer fahren
diagnosis-show-delay = eine Feder an Stelle des Dämpfers fahren: ihre Schleife muss sich schließen
diagnosis-show-drift = einen Referenzversuch am Anfang, in der Mitte und am Ende wiederholen
diagnosis-semicolon = ;{ " " }
diagnosis-beyond = { $test } (über das hinaus, was diese Versuche erreichten: { $demands })
diagnosis-beyond-amplitude = ±{ $value } { $unit }, erreicht wurden ±{ $reached } { $unit }
diagnosis-beyond-speed = { $value } { $unit }, erreicht wurden { $reached } { $unit }
diagnosis-beyond-frequency = { $value } { $unit }, erreicht wurden { $reached } { $unit }
diagnosis-beyond-side-force = eine Seitenkraft von { $value } { $unit }, erreicht wurden { $reached } { $unit }

## What a diagnosis says. Why records cannot show an effect.

diagnosis-needs-series = es gehört zum Reihenpfad: das Modell braucht zuerst die Reihennachgiebigkeit (series_compliance)
diagnosis-series-added = es braucht series_compliance, das diese Diagnose erst ergänzt hat: dashpot diagnose noch einmal auf das verbesserte Modell anwenden
diagnosis-needs-fixed-curve = eine freie FV-Kurve nimmt einen v²-Anteil auf: dazu muss die Kurve durch eine Vorgabe festliegen
diagnosis-needs-side-force = die Seitenkraft ändert sich nicht: denselben Sinus unter zwei oder mehr Seitenkräften fahren und den Kanal aufzeichnen
diagnosis-needs-temperature = kein Temperaturkanal ändert sich, und die Uhren der Messungen zeigen keine Erwärmung: Öl- oder Rohrtemperatur aufzeichnen oder einen Versuch kalt und nach starker Belastung wiederholen
diagnosis-needs-measured-temperature = kein Temperaturkanal ändert sich: in allen Versuchen die Temperatur des Öls oder des Rohrs aufzeichnen
diagnosis-needs-places = alle Versuche durchfahren dieselben Stellen mit denselben Geschwindigkeiten: einen kleinen Sinus in fünf oder mehr Mittellagen fahren oder eine Spitzengeschwindigkeit bei mehreren Hüben
diagnosis-only-within-compression = nur bis { $lowest } { $unit } in Einfederung, wie die Dateien zählen: langsam über das hinaus drücken, was diese Versuche erreichten, um dort einen Anschlag zu sehen
diagnosis-only-within-extension = nur bis { $highest } { $unit } in Ausfederung, wie die Dateien zählen: langsam über das hinaus ziehen, was diese Versuche erreichten, um dort einen Anschlag zu sehen
diagnosis-needs-frequencies = die Frequenzen der Versuche sind fast gleich: eine Spitzengeschwindigkeit bei fünf Frequenzen von { $low } bis { $high } Hz fahren
diagnosis-needs-zero = ein Nullpunktfehler der Kraftmessdose und die Gaskraft sind dieselbe Konstante: die Kraftmessdose bei ausgehängtem Dämpfer ablesen, vorher und nachher
diagnosis-needs-one-clock = jede Messung beginnt ihre Uhr von vorn: eine Uhr durch die ganze Messreihe führen und einen Referenzversuch wiederholen

## What a diagnosis says. What is said of the improved model.

diagnosis-diagnosis = Diagnose: { $answer }
diagnosis-added = { $effect } ({ $percent } sicher) ist diesem Modell hinzugefügt
diagnosis-of-the-rig = { $effect } ({ $percent } sicher) vom Prüfstand: im Vergleich berichtigt, nicht im Dämpfer dieses Modells
diagnosis-or-warm-gas = keine Temperatur ändert sich in allen Messungen: Gas, das sich während der Messreihe erwärmt, lässt die Kraft in Ruhe fallen wie ein wandernder Nullpunkt und ist davon nicht zu unterscheiden. Die Temperatur des Öls oder des Rohrs aufzeichnen
diagnosis-all-fitted-tests = alle angepassten Versuche

## What a diagnosis says. How the comparison was made.

diagnosis-without-reference = ohne Referenzmessreihe kann ein Name auch für das stehen, was die Form des Modells nie richtig wiedergibt; wo ein guter Dämpfer am selben Prüfstand gemessen wurde, zeigt --reference, was sich geändert hat
diagnosis-against-reference = mit der Referenzmessreihe verglichen: was das Modell dort von denselben Versuchen übrig lässt, ist herausgenommen{ $nearest }{ $aside }
diagnosis-by-nearest-motion = ; Versuche ohne Gegenstück gleicher Bewegung wurden mit dem Formfehler des nächstgelegenen verglichen: { $tests }
diagnosis-without-counterpart = ; die Referenz hat keine ähnliche Bewegung, sodass der Formfehler des Modells in ihnen steckt: { $tests }

# What is said of the dimensions of a damper.

## What is said of the dimensions of a damper. Why a quantity cannot be told.

dimensions-no-gas-force = das Modell hat keine Gaskraft; ein langsamer Versuch zeigt sie
dimensions-gas-force-open = die Messungen lassen die Gaskraft offen; ein langsamer Versuch zeigt sie
dimensions-gas-on-rod = das Gas drückt auf die Fläche der Stange
dimensions-no-gas-spring = das Modell hat keine Gasfeder; langsame Hübe über den ganzen Weg zeigen sie
dimensions-gas-spring-open = die Messungen lassen die Gassteifigkeit offen; langsame Hübe über den ganzen Weg zeigen sie
dimensions-volume-from = es folgt aus Druck und Steifigkeit des Gases
dimensions-column-from = die Steifigkeit der Säule ist die einer Kammer mit Fläche und Länge
dimensions-no-column = das Modell hat weder Ölsäule noch Reihenfeder, die die Messungen bestimmen
dimensions-eyes-too-soft = die angegebenen Augen sind, innerhalb ihrer Toleranz, weicher als Augen und Öl zusammen im Modell
dimensions-no-modulus = der effektive Modul ist nicht bekannt
dimensions-tube-expands = das Rohr dehnt sich mit dem Öl
dimensions-stroke-from = der Weg, den Luft nachgibt, hängt von ihrem Druck und der Länge der Kammer ab
dimensions-air-from = es ist das, was dem Modul des Öls fehlt, oder der Weg des Elements aeration
dimensions-passage-from = ein Durchlass folgt aus der FV-Tabelle und der Fläche des Kolbens
dimensions-few-slow-points = weniger als zwei Punkte der FV-Tabelle liegen unter dem Knick dieses Hubs
dimensions-no-knee = die FV-Tabelle dieses Hubs hat keinen Knick: kein Ventil hat geöffnet
dimensions-bleed-passes-all = der Bypass lässt den ganzen Strom durch

## What is said of the dimensions of a damper. What else is to know of a quantity.

dimensions-by-compression = nach der Säule im Druck
dimensions-less-the-eyes = die Reihenfeder ohne die Augen
dimensions-column-bound = eine Schranke: Die Ölsäule enthält auch die Augen; eye_stiffness_n_mm oder eine Reihenfeder im Modell trennt sie
dimensions-column-less-the-eyes = die Ölsäule ohne die Augen, denn das Modell hat keine Feder in Reihe
dimensions-a-bound = eine Grenze: die Reihenfeder enthält Augen und Öl; eye_stiffness_n_mm oder eine Ölsäule im Modell trennt sie
dimensions-with-air = mit der Luft darin
dimensions-no-orifice = neben dem Leck zeigt sich keine Drossel
dimensions-of-all-passages = aller laminaren Durchlässe zusammen; ein Spalt leckt also höchstens so viel
dimensions-spring-is-more-than-gas = falls die Parallelfeder das Gas ist; die gezeichneten { $drawn } cm³ ergeben etwa { $percent } % dieser Feder, den Rest eine andere Feder
dimensions-if-spring-is-gas = falls die Parallelfeder das Gas ist
dimensions-no-leak = neben der Drossel zeigt sich kein Leck
dimensions-opening-at = Öffnung bei der größten Kraft der Tabelle
dimensions-in-doubt = verwendet { $entries } nach Zeichnung; der Widerspruch unten stellt das in Frage
dimensions-had-prior = die Anpassung hatte dafür einen Prior aus den Maßen
dimensions-doubtful-effect = nur falls der Dämpfer { $effect } hat, was nach der Identifikation { $probability } wahrscheinlich ist
dimensions-comma = ,{ " " }
dimensions-semicolon = ;{ " " }

## What is said of the dimensions of a damper. What contradicts.

dimensions-contradicts-one = { $noun } des Modells: { $model } sind das { $ratio }-Fache der { $dimensions }, die sich aus { $facts } ergeben. { $cause }
dimensions-contradicts-several = { $noun } des Modells: { $model } sind das { $ratio }-Fache der { $dimensions }, die { $facts } ergeben. { $cause }
dimensions-contradicts-zero = { $noun } des Modells: { $model } widersprechen den { $dimensions } aus { $facts }. { $cause }
dimensions-explained-by = Die kleinste Änderung einer einzelnen Angabe der Zeichnung, die das erklärt, ist { $entry } = { $value }.
dimensions-no-cause = Keine einzelne Angabe der Zeichnung erklärt das.
dimensions-pressure-on-rod = { $pressure } bar auf einer Stange von { $diameter } mm

## Words in sentences. Words of records.

word-rebound = Zugstufe
word-compression = Druckstufe
word-time = Zeit
word-force = Kraft
word-displacement-or-velocity = Weg oder Geschwindigkeit
word-an-incomplete-cycle-or-run-down = ein unvollständiger Zyklus oder Auslauf
word-rest = Ruhe
word-nothing = nichts
word-current = Strom
word-clicks = Klicks
word-voltage = Spannung
word-pressure = Druck

## Words in sentences. Kinds of tests.

word-slow-tests = langsame Versuche
word-small-strokes = kleine Hübe
word-large-strokes = große Hübe

## Words in sentences. Paths and families of effects.

word-gas-and-springs = Gas und Federn
word-constant-force = konstante Kraft
word-spring = Feder
word-gas-temperature = Gastemperatur
word-friction = Reibung
word-dry-friction = Trockenreibung
word-viscous-friction = viskose Reibung
word-friction-under-load = Reibung unter Last
word-series = Reihenpfad
word-mount = Lagerung
word-hydraulic = Hydraulik
word-oil-column = Ölsäule
word-void = Hohlraum
word-oil-temperature = Öltemperatur
word-valves = Ventile
word-stop = Anschlag
word-rig = Prüfstand
word-mass = Masse
word-timing = Zeitbezug
word-load-cell = Kraftmessdose

## Words in sentences. Forms of effects.

word-changed = geändert
word-full = vollständig
word-simplified = vereinfacht
word-slips-from-the-first = gleitet von Anfang an
word-bends-before-it-slips = biegt sich, bevor es gleitet
word-relaxes = relaxiert
word-friction-in-the-rubber = Reibung im Gummi
word-relaxes-over-decades-and-meets-a-stop = relaxiert über Zeitdekaden und trifft einen Anschlag
word-friction-in-the-rubber-and-a-stop = Reibung im Gummi und ein Anschlag
word-opens-under-a-load = öffnet sich unter einer Last
word-all-of-the-force-goes-through-it = die ganze Kraft geht hindurch
word-friction-and-gas-act-behind-it = Reibung und Gas wirken dahinter
word-relaxes-and-all-of-the-force-goes-through-it = relaxiert, und die ganze Kraft geht hindurch
word-friction-in-the-rubber-and-all-of-the-force-goes-through-it = Reibung im Gummi, und die ganze Kraft geht hindurch
word-rebound-chamber = Zugkammer
word-both-chambers = beide Kammern
word-one-chamber-softer-than-the-other = eine Kammer weicher als die andere
word-compression-capped-gas-pushes-on = Druckstufe begrenzt, Gas drückt weiter
word-compression-capped-dead-return = Druckstufe begrenzt, toter Rückhub
word-rebound-capped-force-stays = Zugstufe begrenzt, Kraft bleibt
word-rebound-capped-dead-return = Zugstufe begrenzt, toter Rückhub
word-compression-capped-gas-expands-in-the-void = Druckstufe begrenzt, Gas dehnt sich im Hohlraum aus
word-foot-valve-does-not-refill = Bodenventil füllt nicht nach
word-measured-temperature = gemessene Temperatur
word-oil-warmer-than-measured = Öl wärmer als gemessen
word-heated-by-its-own-work = durch eigene Arbeit erwärmt
word-rebound-chamber-is-not-refilled = Zugkammer wird nicht nachgefüllt
word-rebound-begins-with-a-lost-stroke = Zugstufe beginnt mit totem Weg
word-compression-begins-with-a-lost-stroke = Druckstufe beginnt mit totem Weg
word-isothermal = isotherm
word-takes-time-to-cool = braucht Zeit zum Abkühlen
word-both-strokes = beide Hübe
word-groove = Nut
word-groove-open-in-rebound = Nut in der Zugstufe offen
word-groove-open-in-compression = Nut in der Druckstufe offen
word-bypass = Bypass-Drossel
word-filter = Filterung
word-stroke = Hub
word-a-valve-with-play = ein Ventil mit Spiel
word-a-valve-with-mass = ein Ventil mit Masse
word-opens-and-closes-at-different-forces = öffnet und schließt bei verschiedenen Kräften
word-linear = linear
word-quadratic = quadratisch
word-cubic = kubisch
word-quartic = vierten Grades
word-rubber = Gummi
word-hydraulic-gap = hydraulisch, Spalt
word-hydraulic-orifice = hydraulisch, Blende
word-on-the-load-cell = auf der Kraftmessdose
word-at-the-load-cell = an der Kraftmessdose
word-inside-like-oil-in-a-long-passage = innen, wie Öl in einem langen Kanal
word-low-pass-filter-of-the-force-channel = Tiefpass im Kraftkanal
word-zero-set-anew-during-the-campaign = Nullpunkt während der Messreihe neu gesetzt
word-settles-as-the-rig-warms-up = stellt sich ein, während der Prüfstand warm wird

## Words in sentences. Quantities of the dimensions, and units that are words.

word-gas-pressure = Gasdruck
word-gas-volume = Gasvolumen
word-effective-modulus-of-the-oil = effektiver Modul des Öls
word-modulus-of-the-oil = Modul des Öls
word-air-content-of-the-oil = Luftgehalt des Öls
word-bleed-area-in-rebound = Bypassfläche im Zug
word-bleed-area-in-compression = Bypassfläche im Druck
word-leak-in-rebound = Leck im Zug
word-leak-in-compression = Leck im Druck
word-blow-off-area-in-rebound = Ventilfläche im Zug
word-blow-off-area-in-compression = Ventilfläche im Druck
word-gas-force = Gaskraft
word-growth-of-the-gas-force-with-temperature = Anstieg der Gaskraft mit der Temperatur
word-gas-stiffness = Gassteifigkeit
word-length-of-the-gas-column = Länge der Gassäule
word-cavitation-cap = Kavitationsgrenze
word-stiffness-of-the-oil-column = Steifigkeit der Ölsäule
word-shortening-of-the-oil-column = Verkürzung der Ölsäule
word-stiffness-of-the-oil-column-in-compression-over-that-in-rebound = Steifigkeit der Ölsäule im Druck durch die im Zug
word-force-that-halves-the-air-s-stroke = Kraft, die den Weg der Luft halbiert
word-stroke-that-the-air-yields = Weg, den die Luft nachgibt
word-series-stiffness = Reihensteifigkeit
word-parallel-spring = Parallelfeder
word-bar-gauge = bar Überdruck
word-at-1-013-bar-absolute = % bei 1,013 bar absolut
word-fv-force-at-two-slow-speeds = fv_force bei zwei langsamen Geschwindigkeiten
word-fv-force-at-a-fast-speed = fv_force bei einer schnellen Geschwindigkeit
word-oil-stiffness-or-aeration-stroke = oil_stiffness oder aeration_stroke
