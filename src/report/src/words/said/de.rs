//! What a diagnosis says, in German.

/// The English text and its translation.
pub const DE: &[(&str, &str)] = &[
    // Lists.
    (", ", ", "),
    (" and ", " und "),
    // The answer.
    (
        "{times} times the error that noise and the form of curves leave",
        "das {times}-Fache des Fehlers, den Rauschen und Form der Kurven lassen",
    ),
    ("{effect} ({percent} sure)", "{effect} ({percent} sicher)"),
    (
        "missing: {names}; what is left falls from {before} to {after} times",
        "es fehlt: {names}; der Rest war {before} und fällt auf das {after}-Fache",
    ),
    (
        "{percent} of the disagreement is not explained by what was named: another form of it, or something else",
        "{percent} der Abweichung sind durch das Benannte nicht erklärt: eine andere Form davon oder etwas anderes",
    ),
    ("{test} ({times} times)", "{test} ({times}-fach)"),
    (
        "too rare or too small to be named, but these tests are missed: {tests}",
        "zu selten oder zu klein, um benannt zu werden, aber diese Versuche werden verfehlt: {tests}",
    ),
    (
        "nothing is missing that these records can show ({percent} sure): the model is off by {times}{not_seen}{not_confirmed}",
        "es fehlt nichts, was diese Messungen zeigen können ({percent} sicher): die Abweichung des Modells ist {times}{not_seen}{not_confirmed}",
    ),
    ("; they cannot show {names}", "; nicht zeigen können sie {names}"),
    ("; no test was left out to confirm it", "; kein Versuch wurde zurückgehalten, um es zu bestätigen"),
    (
        "something is missing: the model is off by {times}, and {why}{place}",
        "etwas fehlt: die Abweichung des Modells ist {times}, und {why}{place}",
    ),
    (
        "{effect} is the likeliest name, but too few tests speak for it to give it",
        "{effect} ist der wahrscheinlichste Name, aber zu wenige Versuche sprechen dafür, um ihn zu vergeben",
    ),
    ("these records cannot tell {names} apart", "diese Messungen können {names} nicht unterscheiden"),
    ("; it acts in the path \"{path}\" ({percent})", "; es wirkt im Pfad „{path}“ ({percent})"),
    (
        "the model is off by {times}, and none of the known effects is likely enough to explain that{nearest}",
        "die Abweichung des Modells ist {times}, und keiner der bekannten Effekte ist wahrscheinlich genug, um das zu erklären{nearest}",
    ),
    ("; it looks like {what}, which explains {percent}", "; es sieht aus wie {what}, was {percent} erklärt"),
    ("; the nearest, {effect}, explains {percent}", "; der nächstliegende, {effect}, erklärt {percent}"),
    ("explains {percent} of the disagreement", "erklärt {percent} der Abweichung"),
    (
        "explains {percent} of the disagreement, with numbers that dampers hardly show",
        "erklärt {percent} der Abweichung, mit Zahlen, die Dämpfer kaum zeigen",
    ),
    // What a disagreement without a name looks like.
    (
        "friction that grows with the force, as a tilted cross-head or eye makes in the guides",
        "Reibung, die mit der Kraft wächst, wie sie eine gekippte Traverse oder ein schiefes Auge in den Führungen macht",
    ),
    (
        "a loop over force whatever the speed, as a load cell with hysteresis draws",
        "eine Schleife über der Kraft bei jeder Geschwindigkeit, wie sie eine Kraftmessdose mit Hysterese zeichnet",
    ),
    (
        "a resonance in the path of the force, as of a frame or of oil in a hose",
        "eine Resonanz im Kraftfluss, wie die eines Rahmens oder von Öl in einem Schlauch",
    ),
    // Regions.
    (
        "{direction}, {slow}–{fast} m/s{phase}, {place}: {missing} (rms {rms} N, noise {noise} N)",
        "{direction}, {slow}–{fast} m/s{phase}, {place}: {missing} (effektiv {rms} N, Rauschen {noise} N)",
    ),
    ("rebound", "Zug"),
    ("compression", "Druck"),
    (" while it speeds up", " beim Schnellerwerden"),
    (" while it slows down", " beim Langsamerwerden"),
    ("in all tests that go there", "in allen Versuchen, die dorthin kommen"),
    ("in test {test}", "im Versuch {test}"),
    (
        "measured force is {mean} N ± {error} more tensile than computed",
        "die gemessene Kraft liegt {mean} N ± {error} weiter im Zug als die berechnete",
    ),
    (
        "measured force is {mean} N ± {error} more compressive than computed",
        "die gemessene Kraft liegt {mean} N ± {error} weiter im Druck als die berechnete",
    ),
    ("{rms} N rms off in both senses", "{rms} N effektiv in beiden Richtungen daneben"),
    // Tests that would tell more.
    (
        "run a sine of {amplitude} mm at {frequency} Hz{about}{under}: {a} and {b} differ there by {difference} N rms",
        "einen Sinus von {amplitude} mm bei {frequency} Hz{about}{under} fahren: {a} und {b} unterscheiden sich dort um {difference} N effektiv",
    ),
    (" about {mean} mm", " um {mean} mm"),
    (" under {force} N side force", " unter {force} N Seitenkraft"),
    ("{effect} shows best in: {remedy}", "{effect} zeigt sich am besten so: {remedy}"),
    (
        "at a usual strength it would leave no trace in these tests: {remedy}",
        "in üblicher Stärke hinterließe es in diesen Versuchen keine Spur: {remedy}",
    ),
    (
        "the tube widens in proportion to pressure like the oil column yields: a rig shows their sum, which oil_compressibility stands for",
        "das Rohr weitet sich mit dem Druck, wie die Ölsäule nachgibt: ein Prüfstand zeigt ihre Summe, für die oil_compressibility steht",
    ),
    // The test that shows an effect best.
    ("more amplitudes and frequencies", "mehr Amplituden und Frequenzen"),
    (
        "slow triangles at 0.5 to 30 mm/s, two strokes, two temperatures",
        "langsame Dreiecke mit 0.5 bis 30 mm/s, zwei Hübe, zwei Temperaturen",
    ),
    (
        "stroke the whole travel slowly, and once at 1 Hz, at two mean positions",
        "den ganzen Hub langsam durchfahren und einmal mit 1 Hz, in zwei Mittellagen",
    ),
    ("0.05 to 0.5 mm sines at 1 to 30 Hz", "Sinus von 0.05 bis 0.5 mm bei 1 bis 30 Hz"),
    (
        "read the force at rest, with and without the damper hooked in",
        "die Kraft in Ruhe ablesen, mit und ohne eingehängten Dämpfer",
    ),
    (
        "strokes of 0.1 to 2 mm at 0.1 and 1 Hz: equal loops speak for it",
        "Hübe von 0.1 bis 2 mm bei 0.1 und 1 Hz: gleiche Schleifen sprechen dafür",
    ),
    ("the same sine at 0, 500 and 1000 N side force", "derselbe Sinus bei 0, 500 und 1000 N Seitenkraft"),
    (
        "one peak velocity at several strokes and frequencies, at two mean positions",
        "eine Spitzengeschwindigkeit bei mehreren Hüben und Frequenzen, in zwei Mittellagen",
    ),
    ("one test after a night's rest and after 200 cycles", "ein Versuch nach einer Nacht Ruhe und nach 200 Zyklen"),
    (
        "one peak velocity at several strokes, with the gas pressure raised",
        "eine Spitzengeschwindigkeit bei mehreren Hüben, mit erhöhtem Gasdruck",
    ),
    (
        "a reference test repeated cold and hot, in shuffled order, with the temperature recorded",
        "ein Referenzversuch kalt und heiß wiederholt, in gemischter Reihenfolge, mit aufgezeichneter Temperatur",
    ),
    ("5 to 10 mm sines at five or more mean positions", "Sinus von 5 bis 10 mm in fünf oder mehr Mittellagen"),
    (
        "push slowly into the stop, then at two speeds",
        "langsam in den Anschlag drücken, dann mit zwei Geschwindigkeiten",
    ),
    (
        "pull slowly into the stop, then at two speeds",
        "langsam in den Anschlag ziehen, dann mit zwei Geschwindigkeiten",
    ),
    (
        "small strokes with a preload that keeps the force from crossing zero, and without",
        "kleine Hübe mit einer Vorlast, die die Kraft nicht durch null gehen lässt, und ohne",
    ),
    ("one peak velocity at 0.5, 1, 2, 5 and 10 Hz", "eine Spitzengeschwindigkeit bei 0.5, 1, 2, 5 und 10 Hz"),
    (
        "slow ramps of velocity through the knee, up and down",
        "langsame Geschwindigkeitsrampen durch den Knick, auf und ab",
    ),
    ("run the rig without the damper", "den Prüfstand ohne den Dämpfer fahren"),
    (
        "run a spring in place of the damper: its loop must close",
        "eine Feder an Stelle des Dämpfers fahren: ihre Schleife muss sich schließen",
    ),
    (
        "repeat a reference test at the start, middle and end",
        "einen Referenzversuch am Anfang, in der Mitte und am Ende wiederholen",
    ),
    // Why records cannot show an effect.
    (
        "it is part of the series path: the model needs series_compliance first",
        "es gehört zum Reihenpfad: das Modell braucht zuerst series_compliance",
    ),
    (
        "a free FV curve takes a v² term up: it needs the curve fixed by a specification",
        "eine freie FV-Kurve nimmt einen v²-Anteil auf: dazu muss die Kurve durch eine Vorgabe festliegen",
    ),
    (
        "the side force does not vary: run the same sine under two or more side forces, with the channel recorded",
        "die Seitenkraft ändert sich nicht: denselben Sinus unter zwei oder mehr Seitenkräften fahren und den Kanal aufzeichnen",
    ),
    (
        "no temperature channel varies, and the records' clocks show no heating: record the oil or tube temperature, or repeat one test cold and after hard work",
        "kein Temperaturkanal ändert sich, und die Uhren der Messungen zeigen keine Erwärmung: Öl- oder Rohrtemperatur aufzeichnen oder einen Versuch kalt und nach harter Arbeit wiederholen",
    ),
    (
        "all tests pass the same places at the same speeds: run one small sine at five or more mean positions, or one peak velocity at several strokes",
        "alle Versuche durchfahren dieselben Stellen mit denselben Geschwindigkeiten: einen kleinen Sinus in fünf oder mehr Mittellagen fahren oder eine Spitzengeschwindigkeit bei mehreren Hüben",
    ),
    (
        "only within the {reach} mm of compression that the tests reach: push slowly further to see a stop beyond",
        "nur innerhalb der {reach} mm Einfederung, die die Versuche erreichen: langsam weiter drücken, um einen Anschlag dahinter zu sehen",
    ),
    (
        "only within the {reach} mm of extension that the tests reach: pull slowly further to see a stop beyond",
        "nur innerhalb der {reach} mm Ausfederung, die die Versuche erreichen: langsam weiter ziehen, um einen Anschlag dahinter zu sehen",
    ),
    (
        "the tests' frequencies are nearly the same: run one peak velocity at 0.5, 1, 2, 5 and 10 Hz",
        "die Frequenzen der Versuche sind fast gleich: eine Spitzengeschwindigkeit bei 0.5, 1, 2, 5 und 10 Hz fahren",
    ),
    (
        "a zero error of the load cell and the gas force are the same constant: read the load cell with the damper unhooked, before and after",
        "ein Nullpunktfehler der Kraftmessdose und die Gaskraft sind dieselbe Konstante: die Kraftmessdose bei ausgehängtem Dämpfer ablesen, vorher und nachher",
    ),
    (
        "every record starts its clock anew: keep one clock through the campaign and repeat a reference test",
        "jede Messung beginnt ihre Uhr von vorn: eine Uhr durch die ganze Messreihe führen und einen Referenzversuch wiederholen",
    ),
    // How the comparison was made.
    (
        "without a reference campaign a name may stand for what is always wrong in the form of the model; where a good damper was measured on the same rig, --reference asks what changed",
        "ohne Referenzmessreihe kann ein Name für das stehen, was an der Form des Modells immer falsch ist; wo ein guter Dämpfer am selben Prüfstand gemessen wurde, fragt --reference, was sich geändert hat",
    ),
    (
        "compared with the reference campaign: what the model leaves of the same tests there is taken out{aside}",
        "mit der Referenzmessreihe verglichen: was das Modell dort von denselben Versuchen übrig lässt, ist herausgenommen{aside}",
    ),
    (
        "; {count} tests have no counterpart there and were left aside: {tests}",
        "; {count} Versuche haben dort kein Gegenstück und blieben beiseite: {tests}",
    ),
    // Where in the way of the force an effect acts.
    ("gas and springs", "Gas und Federn"),
    ("friction", "Reibung"),
    ("series", "in Reihe"),
    ("hydraulic", "Hydraulik"),
    ("rig", "Prüfstand"),
    ("nothing", "nichts"),
    ("something else", "etwas anderes"),
    // Families of effects.
    ("constant force", "konstante Kraft"),
    ("spring", "Feder"),
    ("dry friction", "Trockenreibung"),
    ("viscous friction", "viskose Reibung"),
    ("friction under load", "Reibung unter Last"),
    ("mount", "Lagerung"),
    ("oil column", "Ölsäule"),
    ("void", "Hohlraum"),
    ("oil temperature", "Öltemperatur"),
    ("valves", "Ventile"),
    ("stop", "Anschlag"),
    ("mass", "Masse"),
    ("timing", "Zeitbezug"),
    ("load cell", "Kraftmessdose"),
    // What an effect is.
    ("constant gas force", "konstante Gaskraft"),
    (
        "growth of the gas force with the displacement of the rod, slow to fast",
        "Anstieg der Gaskraft mit dem Weg der Kolbenstange, langsam bis schnell",
    ),
    ("dry friction of constant level, F_s tanh(K v)", "Trockenreibung konstanter Höhe, F_s tanh(K v)"),
    ("dry friction with a break-away peak", "Trockenreibung mit Losbrechspitze"),
    (
        "friction that turns over within a short travel after each reversal (Dahl)",
        "Reibung, die nach jeder Umkehr auf kurzem Weg umschlägt (Dahl)",
    ),
    ("viscous friction, F_v v|v|", "viskose Reibung, F_v v|v|"),
    ("dry friction proportional to side force", "Trockenreibung proportional zur Seitenkraft"),
    (
        "series spring and damper with the internal mass (compressibility of gas, oil and mount)",
        "Feder und Dämpfer in Reihe mit der inneren Masse (Nachgiebigkeit von Gas, Öl und Lager)",
    ),
    (
        "rubber in line with the damper: the series spring hardens and loses energy; needs series_compliance",
        "Gummi in Reihe mit dem Dämpfer: die Reihenfeder versteift sich und verliert Energie; braucht series_compliance",
    ),
    (
        "spring parallel to the primary damper: linear, quadratic, cubic, quartic or lookup",
        "Feder parallel zum Hauptdämpfer: linear, quadratisch, kubisch, vierten Grades oder Tabelle",
    ),
    (
        "compressibility of the oil column (with the expansion of the cylinder) before the valves",
        "Nachgiebigkeit der Ölsäule (mit der Aufweitung des Zylinders) vor den Ventilen",
    ),
    (
        "air in the oil: the oil column is soft while the force is small",
        "Luft im Öl: die Ölsäule ist weich, solange die Kraft klein ist",
    ),
    (
        "cavitation: the hydraulic force of one stroke is capped, and a void remains to be closed",
        "Kavitation: die hydraulische Kraft eines Hubs ist begrenzt, und ein Hohlraum bleibt zu schließen",
    ),
    (
        "damping that falls with the temperature of the oil, measured or by its own heat",
        "Dämpfung, die mit der Öltemperatur fällt, gemessen oder durch eigene Wärme",
    ),
    (
        "damping that is weaker (bypass) or firmer over a part of the stroke",
        "Dämpfung, die über einen Teil des Hubs schwächer (Bypass) oder straffer ist",
    ),
    (
        "stop at the end of the compression stroke, rubber or hydraulic",
        "Anschlag am Ende des Druckhubs, aus Gummi oder hydraulisch",
    ),
    (
        "stop at the end of the rebound stroke, rubber or hydraulic",
        "Anschlag am Ende des Zughubs, aus Gummi oder hydraulisch",
    ),
    (
        "free play in an eye or mount; needs series_compliance",
        "Spiel in einem Auge oder Lager; braucht series_compliance",
    ),
    (
        "damping that is weaker in fast strokes than in slow ones of the same speed",
        "Dämpfung, die in schnellen Hüben schwächer ist als in langsamen gleicher Geschwindigkeit",
    ),
    (
        "blow-off valve that opens late and closes late: more force while speed rises",
        "Abblasventil, das spät öffnet und spät schließt: mehr Kraft, während die Geschwindigkeit steigt",
    ),
    (
        "mass moved by the driven end, between load cell and damper, or by the piston",
        "Masse, die das angetriebene Ende zwischen Kraftmessdose und Dämpfer oder der Kolben bewegt",
    ),
    ("the force channel lags the motion channels (rig)", "der Kraftkanal eilt den Bewegungskanälen nach (Prüfstand)"),
    ("the load cell does not read zero without load (rig)", "die Kraftmessdose zeigt ohne Last nicht null (Prüfstand)"),
    (
        "the zero of the load cell moves with time (rig)",
        "der Nullpunkt der Kraftmessdose wandert mit der Zeit (Prüfstand)",
    ),
    // Forms of effects.
    ("full", "vollständig"),
    ("slips from the first", "gleitet von Anfang an"),
    ("bends before it slips", "biegt sich, bevor es gleitet"),
    ("relaxes", "relaxiert"),
    ("friction in the rubber", "Reibung im Gummi"),
    ("relaxes over decades and meets a stop", "relaxiert über Zeitdekaden und trifft einen Anschlag"),
    ("friction in the rubber, and a stop", "Reibung im Gummi und ein Anschlag"),
    ("all of the force goes through it", "die ganze Kraft geht hindurch"),
    ("relaxes, and all of the force goes through it", "relaxiert, und die ganze Kraft geht hindurch"),
    (
        "friction in the rubber, and all of the force goes through it",
        "Reibung im Gummi, und die ganze Kraft geht hindurch",
    ),
    ("rebound chamber", "Zugkammer"),
    ("both chambers", "beide Kammern"),
    ("one chamber softer than the other", "eine Kammer weicher als die andere"),
    ("compression capped, gas pushes on", "Druck begrenzt, Gas drückt weiter"),
    ("compression capped, dead return", "Druck begrenzt, toter Rückhub"),
    ("rebound capped, force stays", "Zug begrenzt, Kraft bleibt"),
    ("rebound capped, dead return", "Zug begrenzt, toter Rückhub"),
    ("compression capped, gas expands in the void", "Druck begrenzt, Gas dehnt sich im Hohlraum aus"),
    ("foot valve does not refill", "Bodenventil füllt nicht nach"),
    ("measured temperature", "gemessene Temperatur"),
    ("oil warmer than measured", "Öl wärmer als gemessen"),
    ("heated by its own work", "durch eigene Arbeit erwärmt"),
    ("isothermal", "isotherm"),
    ("takes time to cool", "braucht Zeit zum Abkühlen"),
    ("both strokes", "beide Hübe"),
    ("groove", "Nut"),
    ("groove open in rebound", "Nut offen im Zug"),
    ("groove open in compression", "Nut offen im Druck"),
    ("bypass", "Bypass-Drossel"),
    ("filter", "Filterung"),
    ("stroke", "Hub"),
    ("a valve with play", "ein Ventil mit Spiel"),
    ("a valve with mass", "ein Ventil mit Masse"),
    ("opens and closes at different forces", "öffnet und schließt bei verschiedenen Kräften"),
    ("rubber", "Gummi"),
    ("hydraulic, gap", "hydraulisch, Spalt"),
    ("hydraulic, orifice", "hydraulisch, Blende"),
    ("at the load cell", "an der Kraftmessdose"),
    ("inside, like oil in a long passage", "innen, wie Öl in einem langen Kanal"),
    ("low-pass filter of the force channel", "Tiefpass im Kraftkanal"),
    ("zero set anew during the campaign", "Nullpunkt während der Messreihe neu gesetzt"),
    ("settles as the rig warms up", "stellt sich ein, während der Prüfstand warm wird"),
];
