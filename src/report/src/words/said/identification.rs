//! What a fit says.

use super::Said;

/// In the order of its phrases.
pub const ALL: &[Said] = &[
    // Lists.
    [", that ", ", dass ", ", que ", "，"],
    // Which tests a number was identified from.
    ["{tests} {percent} %", "{tests} {percent} %", "{tests} {percent} %", "{tests} {percent} %"],
    ["no test shows it", "kein Versuch zeigt es", "aucun essai ne le montre", "没有试验能显示"],
    // The inventory.
    [
        "{effect}: {force} N rms, {share} of the force; probability {probability}",
        "{effect}: {force} N effektiv, {share} der Kraft; Wahrscheinlichkeit {probability}",
        "{effect} : {force} N efficaces, {share} de l’effort ; probabilité {probability}",
        "{effect}：均方根 {force} N，占力的 {share}；概率 {probability}",
    ],
    [
        "{effect} ({form}): {force} N rms, {share} of the force; probability {probability}",
        "{effect} ({form}): {force} N effektiv, {share} der Kraft; Wahrscheinlichkeit {probability}",
        "{effect} ({form}) : {force} N efficaces, {share} de l’effort ; probabilité {probability}",
        "{effect}（{form}）：均方根 {force} N，占力的 {share}；概率 {probability}",
    ],
    // What the data does not determine.
    [
        "{name} could not be identified from this data ({why}); its element is off",
        "{name} ließ sich aus diesen Daten nicht identifizieren ({why}); das Element ist aus",
        "{name} n’a pu être identifié de ces données ({why}) ; son élément est désactivé",
        "{name} 无法由这些数据辨识（{why}）；其元件未启用",
    ],
    [
        "it needs slow tests at two or more side forces, with a side-force channel",
        "dazu braucht es langsame Versuche bei zwei oder mehr Seitenkräften, mit einem Kanal der Seitenkraft",
        "il faut des essais lents à deux efforts latéraux ou plus, avec une voie d’effort latéral",
        "需要在两种或更多侧向力下的慢速试验，并有侧向力通道",
    ],
    [
        "a free FV curve takes a v² term up",
        "eine freie FV-Kurve nimmt einen v²-Anteil auf",
        "une courbe FV libre absorbe un terme en v²",
        "自由的 FV 曲线会吸收 v² 项",
    ],
    [
        "{name} could not be identified from this data; it is held at {value} {unit}",
        "{name} ließ sich aus diesen Daten nicht identifizieren; der Wert ist auf {value} {unit} gehalten",
        "{name} n’a pu être identifié de ces données ; sa valeur est tenue à {value} {unit}",
        "{name} 无法由这些数据辨识；固定为 {value} {unit}",
    ],
    [
        "{name} ran into the bound of its range at {value} {unit}: the data asks for something this element cannot do",
        "{name} stieß bei {value} {unit} an die Grenze seines Bereichs: die Daten verlangen etwas, was dieses Element nicht kann",
        "{name} a atteint la borne de son domaine à {value} {unit} : les données demandent ce que cet élément ne peut faire",
        "{name} 到达其范围边界 {value} {unit}：数据要求的是该元件做不到的",
    ],
    // What the campaign cannot show.
    [
        "all tests turn at nearly the same rate, so that a late force channel and a soft series path look alike: the channel was taken as on time; the same stroke at three times the frequency would tell them apart",
        "alle Versuche kehren fast gleich schnell um, so dass ein später Kraftkanal und ein weicher Reihenpfad gleich aussehen: der Kanal gilt als unverzögert; derselbe Hub bei dreifacher Frequenz würde sie unterscheiden",
        "tous les essais se retournent presque au même rythme, si bien qu’une voie d’effort en retard et un chemin série souple se ressemblent : la voie a été prise sans retard ; la même course à trois fois la fréquence les distinguerait",
        "所有试验的换向快慢几乎相同，力通道滞后与串联路径偏软看起来一样：认为该通道没有滞后；以三倍频率做同一行程的试验可将二者区分",
    ],
    [
        "{roads} long tests without cycles are run in {stretches} stretches of {seconds} s each, chosen to visit every displacement and velocity of theirs; errors over whole records count every sample",
        "{roads} lange Versuche ohne Zyklen werden in {stretches} Abschnitten von je {seconds} s gerechnet, die jeden ihrer Wege und jede ihrer Geschwindigkeiten berühren; Fehler über ganze Aufzeichnungen zählen jeden Messpunkt",
        "{roads} longs essais sans cycles sont calculés en {stretches} tronçons de {seconds} s, choisis pour parcourir tous leurs déplacements et toutes leurs vitesses ; les erreurs sur enregistrements entiers comptent chaque échantillon",
        "{roads} 个没有循环的长试验各以 {stretches} 段、每段 {seconds} s 计算，所选各段经过其全部位移和速度；全记录误差计入每个采样点",
    ],
    [
        "the campaign has {all} tests, more than a search can use: {selected} of them stand for all, of every amplitude, speed, mean displacement, temperature and side force, spread over its whole length. Errors over whole records count all tests; to decide yourself, give --exclude or a smaller folder",
        "die Messreihe hat {all} Versuche, mehr als eine Suche nutzen kann: {selected} davon stehen für alle, aus jeder Amplitude, Geschwindigkeit, Mittellage, Temperatur und Seitenkraft, über die ganze Reihe verteilt. Fehler über ganze Aufzeichnungen zählen alle Versuche; um selbst zu wählen, --exclude oder einen kleineren Ordner angeben",
        "la campagne compte {all} essais, plus qu’une recherche n’en peut utiliser : {selected} d’entre eux représentent l’ensemble, de chaque amplitude, vitesse, position moyenne, température et effort latéral, répartis sur toute sa durée. Les erreurs sur enregistrements entiers comptent tous les essais ; pour choisir soi-même, donner --exclude ou un dossier plus petit",
        "本次测量有 {all} 个试验，多于搜索所能使用的数量：以其中 {selected} 个代表全部，涵盖各种振幅、速度、平均位置、温度和侧向力，并分布于整个过程。全记录误差计入所有试验；若要自行选择，请使用 --exclude 或较小的文件夹",
    ],
    [
        "the campaign has {all} tests, more than a search can use: {selected} of them stand for all, at most {most} of each setting and {changing} whose setting changes, of every amplitude, speed, mean displacement, temperature and side force. Errors over whole records count all tests; to decide yourself, give --exclude or a smaller folder",
        "die Messreihe hat {all} Versuche, mehr als eine Suche nutzen kann: {selected} davon stehen für alle, höchstens {most} je Einstellung und {changing} mit wechselnder Einstellung, aus jeder Amplitude, Geschwindigkeit, Mittellage, Temperatur und Seitenkraft. Fehler über ganze Aufzeichnungen zählen alle Versuche; um selbst zu wählen, --exclude oder einen kleineren Ordner angeben",
        "la campagne compte {all} essais, plus qu’une recherche n’en peut utiliser : {selected} d’entre eux représentent l’ensemble, au plus {most} par réglage et {changing} dont le réglage varie, de chaque amplitude, vitesse, position moyenne, température et effort latéral. Les erreurs sur enregistrements entiers comptent tous les essais ; pour choisir soi-même, donner --exclude ou un dossier plus petit",
        "本次测量有 {all} 个试验，多于搜索所能使用的数量：以其中 {selected} 个代表全部，每个设置最多 {most} 个，设置变化的 {changing} 个，涵盖各种振幅、速度、平均位置、温度和侧向力。全记录误差计入所有试验；若要自行选择，请使用 --exclude 或较小的文件夹",
    ],
    [
        "there is no slow test (peak below {velocity} mm/s): friction is taken from the slow parts of faster tests",
        "es gibt keinen langsamen Versuch (Spitze unter {velocity} mm/s): die Reibung kommt aus den langsamen Teilen schnellerer Versuche",
        "il n’y a pas d’essai lent (pointe sous {velocity} mm/s) : le frottement est tiré des parties lentes d’essais plus rapides",
        "没有慢速试验（峰值低于 {velocity} mm/s）：摩擦取自较快试验的慢速部分",
    ],
    [
        "all tests have nearly the same amplitude: the spring and the series stiffness rest on frequency alone",
        "alle Versuche haben fast dieselbe Amplitude: Feder und Reihensteifigkeit beruhen allein auf der Frequenz",
        "tous les essais ont presque la même amplitude : le ressort et la raideur série ne reposent que sur la fréquence",
        "所有试验的振幅几乎相同：弹簧和串联刚度仅由频率确定",
    ],
    [
        "the model leaves another constant force of each test, from {low} to {high} N: the zero of the force channel moves from test to test, or the gas warms up. Set the zero before each test, or measure on one clock, by which a drift is found; friction and gas force are not to be trusted",
        "das Modell lässt von jedem Versuch eine andere gleichbleibende Kraft übrig, von {low} bis {high} N: der Nullpunkt des Kraftkanals wandert von Versuch zu Versuch, oder das Gas erwärmt sich. Vor jedem Versuch nullen oder mit einer durchlaufenden Uhr messen, mit der eine Drift gefunden wird; Reibung und Gaskraft sind nicht verlässlich",
        "le modèle laisse de chaque essai un autre effort constant, de {low} à {high} N : le zéro de la voie d’effort bouge d’un essai à l’autre, ou le gaz s’échauffe. Faire le zéro avant chaque essai, ou mesurer sur une seule horloge, qui permet de trouver une dérive ; frottement et effort du gaz ne sont pas fiables",
        "模型在各试验中剩下各不相同的恒定力，从 {low} 到 {high} N：力通道的零点在试验之间移动，或气体升温。请在每次试验前调零，或用同一时钟连续测量以便找出漂移；摩擦力和气体力不可信",
    ],
    // What the measurement is off by.
    [
        "the force channel comes late by {value} ms (95 %: {low} to {high})",
        "der Kraftkanal kommt {value} ms zu spät (95 %: {low} bis {high})",
        "la voie d’effort est en retard de {value} ms (95 % : {low} à {high})",
        "力通道滞后 {value} ms（95 %：{low} 至 {high}）",
    ],
    [
        "the force channel comes early by {value} ms (95 %: {low} to {high})",
        "der Kraftkanal kommt {value} ms zu früh (95 %: {low} bis {high})",
        "la voie d’effort est en avance de {value} ms (95 % : {low} à {high})",
        "力通道超前 {value} ms（95 %：{low} 至 {high}）",
    ],
    [
        "the load cell moves a mass of its own, of {value} kg (95 %: {low} to {high})",
        "die Kraftmessdose bewegt eine eigene Masse von {value} kg (95 %: {low} bis {high})",
        "le capteur d’effort entraîne une masse propre de {value} kg (95 % : {low} à {high})",
        "力传感器带动自身的质量 {value} kg（95 %：{low} 至 {high}）",
    ],
    [
        "the gain of the force channel drifts by {value} % a minute (95 %: {low} to {high})",
        "die Verstärkung des Kraftkanals wandert um {value} % je Minute (95 %: {low} bis {high})",
        "le gain de la voie d’effort dérive de {value} % par minute (95 % : {low} à {high})",
        "力通道的增益每分钟漂移 {value} %（95 %：{low} 至 {high}）",
    ],
    [
        "the zero of the force channel drifts by {value} N a minute (95 %: {low} to {high})",
        "der Nullpunkt des Kraftkanals wandert um {value} N je Minute (95 %: {low} bis {high})",
        "le zéro de la voie d’effort dérive de {value} N par minute (95 % : {low} à {high})",
        "力通道的零点每分钟漂移 {value} N（95 %：{low} 至 {high}）",
    ],
    [
        "{finding}: taken out here, not in the model; validate and diagnose take it out of these records too{option}",
        "{finding}: hier herausgerechnet, nicht im Modell; validate und diagnose rechnen es aus diesen Messungen ebenfalls heraus{option}",
        "{finding} : retiré ici, absent du modèle ; validate et diagnose le retirent aussi de ces mesures{option}",
        "{finding}：此处已去除，不在模型中；validate 和 diagnose 也会从这些记录中去除{option}",
    ],
    [
        "; for other records of this rig give {option}, or write it into their campaign.toml",
        "; für andere Messungen dieses Prüfstands {option} angeben oder in ihre campaign.toml schreiben",
        " ; pour d’autres mesures de ce banc, donner {option}, ou l’écrire dans leur campaign.toml",
        "；对该试验台的其他记录请给出 {option}，或写入其 campaign.toml",
    ],
    [
        "taken out of the records, as the model's fit did: {findings}",
        "aus den Messungen herausgerechnet, wie bei der Identifikation des Modells: {findings}",
        "retiré des mesures, comme l’a fait l’identification du modèle : {findings}",
        "已按模型辨识时的做法从记录中去除：{findings}",
    ],
    [
        "the model's fit found in its own records that {findings}; these are other records, and nothing was taken out of them{option}",
        "die Identifikation des Modells fand in ihren eigenen Messungen: {findings}; dies sind andere Messungen, und aus ihnen wurde nichts herausgerechnet{option}",
        "l’identification du modèle a trouvé dans ses propres mesures que {findings} ; celles-ci en sont d’autres, et rien n’en a été retiré{option}",
        "模型辨识在其自身的记录中发现：{findings}；这里是别的记录，未从中去除任何成分{option}",
    ],
    [
        ": if the same rig measured these, give {options}",
        ": hat derselbe Prüfstand diese gemessen, {options} angeben",
        " : si le même banc les a mesurées, donner {options}",
        "：如果由同一试验台测得，请给出 {options}",
    ],
    // What a model file holds that does nothing.
    [
        "the model file gives {names}, but the element {element} is off, so that this does nothing; add it to elements to use it",
        "die Modelldatei gibt {names} an, aber das Element {element} ist aus, sodass dies nichts bewirkt; um es zu nutzen, in elements aufnehmen",
        "le fichier de modèle donne {names}, mais l’élément {element} est désactivé, et cela reste sans effet ; pour s’en servir, l’ajouter à elements",
        "模型文件给出了 {names}，但元件 {element} 已关闭，因此这些值不起作用；如需使用，请将其加入 elements",
    ],
    [
        "a fit of this setting alone misses by {ratio} times as much as the family, so its search ended at a poorer structure: the ratio to it says nothing",
        "ein Fit dieser Einstellung allein weicht {ratio}-mal so weit ab wie die Familie, seine Suche endete also bei einer schlechteren Struktur: das Verhältnis dazu sagt nichts",
        "un ajustement de ce réglage seul s’écarte {ratio} fois autant que la famille, sa recherche a donc fini à une structure moins bonne : le rapport à lui ne dit rien",
        "单独拟合此设置的偏差是整族的 {ratio} 倍，即其搜索停在较差的结构：与它之比没有意义",
    ],
    [
        "the family misses by {ratio} times as much as a fit of this setting alone: a number that all share may differ here, or these tests are too few to show that it does",
        "die Familie weicht {ratio}-mal so weit ab wie eine Identifikation dieser Einstellung allein: Eine Zahl, die alle teilen, mag hier eine andere sein, oder diese Versuche sind zu wenige, um das zu zeigen",
        "la famille s’écarte {ratio} fois autant qu’une identification de ce seul réglage : une valeur commune à tous peut être différente ici, ou ces essais sont trop peu nombreux pour le montrer",
        "该族模型的误差是仅对此设定单独辨识的 {ratio} 倍：各设定共用的某个参数在此可能不同，或这些试验太少而无法表明这一点",
    ],
    [
        "the element {element} is on, but the model file does not give {names}: it runs on the defaults of docs/parameters.md",
        "das Element {element} ist an, aber die Modelldatei gibt {names} nicht an: Es gelten die Vorgaben aus docs/parameters.md",
        "l’élément {element} est actif, mais le fichier de modèle ne donne pas {names} : les valeurs par défaut de docs/parameters.md s’appliquent",
        "元件 {element} 已启用，但模型文件未给出 {names}：采用 docs/parameters.md 中的默认值",
    ],
    [
        "{names}: outside the 95 % interval that the fit left in the model file, so changed since; what the fit knew of it is left out",
        "{names}: außerhalb des 95-%-Intervalls, das die Identifikation in der Modelldatei hinterließ, also seither geändert; was die Identifikation dazu wusste, entfällt",
        "{names} : hors de l’intervalle à 95 % laissé par l’identification dans le fichier de modèle, donc modifié depuis ; ce que l’identification en savait est omis",
        "{names}：超出辨识在模型文件中给出的 95 % 区间，因此此后被修改过；辨识对其所知的内容不再列出",
    ],
    // How far a fit is.
    ["preparing records", "Messungen werden vorbereitet", "préparation des mesures", "正在准备试验记录"],
    ["plain FV curve", "einfache FV-Kurve", "courbe FV simple", "普通 FV 曲线"],
    [
        "first fit from several starts",
        "erste Anpassung von mehreren Startwerten aus",
        "premier ajustement depuis plusieurs départs",
        "由多个起点进行首次拟合",
    ],
    [
        "comparing friction, springs, series path and measurement errors",
        "Reibung, Federn, Reihenpfad und Messfehler werden verglichen",
        "comparaison du frottement, des ressorts, du chemin en série et des erreurs de mesure",
        "比较摩擦、弹簧、串联路径和测量误差",
    ],
    ["refining everything together", "alles gemeinsam verfeinern", "affinage de l’ensemble", "整体精修"],
    ["piecewise-linear curve", "stückweise lineare Kurve", "courbe linéaire par morceaux", "分段线性曲线"],
    ["polynomial with lag", "Polynom mit Verzögerung", "polynôme avec retard", "带滞后的多项式"],
    ["done", "fertig", "terminé", "完成"],
    // A damper over a setting.
    ["each setting by itself", "jede Einstellung für sich", "chaque réglage à part", "逐个设置"],
    [
        "all settings together: what they share and what depends on them",
        "alle Einstellungen zusammen: was ihnen gemeinsam ist und was von ihnen abhängt",
        "tous les réglages ensemble : ce qui leur est commun et ce qui en dépend",
        "所有设置一起：哪些共有，哪些随设置变化",
    ],
    [
        "each setting predicted by the others",
        "jede Einstellung aus den anderen vorhergesagt",
        "chaque réglage prédit par les autres",
        "由其他设置预测每个设置",
    ],
    [
        "response of the valve from tests whose setting changes",
        "Antwort des Ventils aus Versuchen mit veränderlicher Einstellung",
        "réponse de la valve d’après les essais à réglage variable",
        "由设置变化的试验得到阀的响应",
    ],
    [
        "tests whose setting changes",
        "Versuche mit veränderlicher Einstellung",
        "essais à réglage variable",
        "设置变化的试验",
    ],
    [
        "the {count} tests whose {setting} changes show no actuator: the force follows the command within their samples and their noise",
        "die {count} Versuche mit veränderlicher Einstellung ({setting}) zeigen keinen Steller: die Kraft folgt dem Befehl innerhalb von Abtastung und Rauschen",
        "les {count} essais à réglage variable ({setting}) ne montrent aucun actionneur : l’effort suit la commande dans la limite de l’échantillonnage et du bruit",
        "{count} 个{setting}变化的试验未显示执行器：力在采样和噪声范围内跟随指令",
    ],
    [
        "the records do not determine {names}: the values are those that valves usually show",
        "die Messungen bestimmen {names} nicht: die Werte sind solche, wie Ventile sie meist zeigen",
        "les mesures ne déterminent pas {names} : les valeurs sont celles que montrent d’ordinaire les valves",
        "记录不能确定 {names}：取阀通常的数值",
    ],
    [
        "{names}: no interval here, between two settings; a fit at three or more settings shows how far interpolation is off",
        "{names}: hier, zwischen zwei Einstellungen, kein Intervall; erst drei oder mehr Einstellungen zeigen, wie weit die Interpolation abweicht",
        "{names} : pas d’intervalle ici, entre deux réglages ; un ajustement à trois réglages ou plus montre l’erreur de l’interpolation",
        "{names}：位于两个设置之间，此处无区间；拟合三个或更多设置才能显示插值误差",
    ],
    [
        "{test} states {name} {stated}, but its forces are those of {fitting}: at the stated one the model misses it by {ratio} times as much. Check its label; a corrected value goes into campaign.toml under settings",
        "{test} gibt {name} {stated} an, doch seine Kräfte sind die von {fitting}: bei der angegebenen Einstellung verfehlt das Modell ihn um das {ratio}-Fache. Die Angabe prüfen; ein berichtigter Wert gehört in campaign.toml unter settings",
        "{test} indique {name} {stated}, mais ses forces sont celles de {fitting} : au réglage indiqué, le modèle s’en écarte {ratio} fois plus. Vérifier cette indication ; une valeur corrigée se met dans campaign.toml sous settings",
        "{test} 标明 {name} {stated}，但其力属于 {fitting}：在所标设定下模型的误差为后者的 {ratio} 倍。请检查该标注；更正值写入 campaign.toml 的 settings",
    ],
    [
        "the damping force does not rise or fall throughout over the {name}; with {one} and {other} exchanged it would. Check the labels of these tests; a damper that is really so is modeled as measured",
        "die Dämpfkraft steigt oder fällt über {name} nicht durchgehend; mit {one} und {other} vertauscht täte sie es. Die Angaben dieser Versuche prüfen; ein Dämpfer, der wirklich so ist, wird wie gemessen modelliert",
        "l’effort d’amortissement ne croît ni ne décroît d’un bout à l’autre de {name} ; il le ferait avec {one} et {other} échangés. Vérifier les indications de ces essais ; un amortisseur réellement ainsi est modélisé comme mesuré",
        "阻尼力在 {name} 上并非单调变化；若将 {one} 与 {other} 互换则会单调。请检查这些试验的标注；若阻尼器确实如此，则按测量建模",
    ],
    [
        "a change of {setting} may do work on the host, for it changes {names}: energy that is stored, or a force at rest",
        "eine Änderung von {setting} kann am Fahrzeug Arbeit leisten, denn sie ändert {names}: gespeicherte Energie oder eine Kraft in Ruhe",
        "un changement de {setting} peut fournir un travail au véhicule, car il modifie {names} : énergie accumulée ou force au repos",
        "改变 {setting} 可能对宿主做功，因为它改变 {names}：储存的能量或静止时的力",
    ],
    [
        "no test says its {name}. Write it into the names of all tests (800mA, 12clicks, 150psi), name its column (--column setting=HEADING), give the unit of a column of currents whose heading has none (--unit current=A), or write setting and [settings] into campaign.toml beside them",
        "kein Versuch nennt {name}. In die Namen aller Versuche schreiben (800mA, 12clicks, 150psi), die Spalte angeben (--column setting=HEADING), die Einheit einer Stromspalte ohne Einheit nennen (--unit current=A), oder setting und [settings] in campaign.toml daneben eintragen",
        "aucun essai n’indique {name}. L’écrire dans les noms de tous les essais (800mA, 12clicks, 150psi), donner sa colonne (--column setting=HEADING), donner l’unité d’une colonne de courant qui n’en a pas (--unit current=A), ou écrire setting et [settings] dans campaign.toml à côté",
        "没有试验说明 {name}。请写入所有试验的名称（800mA、12clicks、150psi），给出其列（--column setting=HEADING），给出无单位电流列的单位（--unit current=A），或在旁边的 campaign.toml 中写入 setting 和 [settings]",
    ],
    [
        "no test says its {name}; the tests have a setting called {known}: give --setting with that name",
        "kein Versuch nennt {name}; die Versuche haben eine Einstellung namens {known}: --setting mit diesem Namen angeben",
        "aucun essai n’indique {name} ; les essais ont un réglage nommé {known} : donner --setting avec ce nom",
        "没有试验说明 {name}；试验的设置名为 {known}：请用该名称给出 --setting",
    ],
    [
        "{count} tests say nothing of their {name}: {tests}. Leave them out with --exclude, name their column (--column setting=HEADING), or give it in campaign.toml under settings",
        "{count} Versuche nennen {name} nicht: {tests}. Mit --exclude weglassen, ihre Spalte nennen (--column setting=HEADING), oder in campaign.toml unter settings angeben",
        "{count} essais n’indiquent pas {name} : {tests}. Les écarter avec --exclude, nommer leur colonne (--column setting=HEADING), ou le donner dans campaign.toml sous settings",
        "{count} 个试验没有说明 {name}：{tests}。请用 --exclude 排除，用 --column setting=HEADING 指明其列，或在 campaign.toml 的 settings 中给出",
    ],
    [
        "all tests at a constant {name} have the same, {value}: a model over it needs at least two. Fit them without --setting, or check the unit of its column",
        "alle Versuche bei konstantem Wert von {name} haben denselben, {value}: ein Modell darüber braucht mindestens zwei. Ohne --setting anpassen, oder die Einheit der Spalte prüfen",
        "tous les essais à {name} constant ont la même valeur, {value} : un modèle en fonction de ce réglage en demande au moins deux. Les ajuster sans --setting, ou vérifier l’unité de la colonne",
        "所有恒定 {name} 的试验都是 {value}：随其变化的模型至少需要两个值。请不带 --setting 拟合，或检查该列的单位",
    ],
    [
        "the {name} of all {count} tests changes within the test: a damper over it is fitted to tests at two or more constant settings, and those that change identify its valve",
        "{name} ändert sich in allen {count} Versuchen: ein Dämpfer darüber wird an Versuche bei zwei oder mehr festen Einstellungen angepasst; veränderliche bestimmen sein Ventil",
        "{name} varie pendant chacun des {count} essais : un amortisseur s’ajuste à des essais à deux réglages constants au moins ; ceux où il varie identifient sa valve",
        "全部 {count} 个试验中 {name} 都在变化：随其变化的减振器须用两个或更多恒定设置下的试验拟合，变化的试验用于辨识其阀",
    ],
    [
        "the tests have {count} values of {name}, and a model holds {most}: leave some out with --exclude or --hold-out, or state what was set in campaign.toml under [settings]",
        "die Versuche haben {count} Werte von {name}, und ein Modell fasst {most}: einige mit --exclude oder --hold-out weglassen, oder in campaign.toml unter [settings] angeben, was eingestellt war",
        "les essais ont {count} valeurs de {name}, et un modèle en contient {most} : en écarter avec --exclude ou --hold-out, ou indiquer le réglage dans campaign.toml sous [settings]",
        "试验有 {count} 个 {name} 值，而模型最多容纳 {most} 个：请用 --exclude 或 --hold-out 排除一些，或在 campaign.toml 的 [settings] 中写明设定值",
    ],
    [
        "at {name} = {value}: {why}",
        "bei {name} = {value}: {why}",
        "à {name} = {value} : {why}",
        "{name} = {value} 时：{why}",
    ],
    [
        "the settings make no model: {parameter} {why}",
        "die Einstellungen ergeben kein Modell: {parameter} {why}",
        "les réglages ne font pas un modèle : {parameter} {why}",
        "这些设置不能构成模型：{parameter} {why}",
    ],
    [
        "no finite force could be computed for all settings together; fit each by itself to find the test at fault",
        "für alle Einstellungen zusammen ließ sich keine endliche Kraft berechnen; jede für sich anpassen, um den Versuch zu finden",
        "aucun effort fini n’a pu être calculé pour tous les réglages ensemble ; ajuster chacun à part pour trouver l’essai en cause",
        "无法为所有设置一起计算出有限的力；请逐个拟合以找出有问题的试验",
    ],
    // Why there is no fit.
    [
        "there is no test to fit: give a folder or files with at least one record",
        "es gibt keinen Versuch zum Anpassen: einen Ordner oder Dateien mit mindestens einer Messung angeben",
        "il n’y a aucun essai à ajuster : donner un dossier ou des fichiers avec au moins une mesure",
        "没有可拟合的试验：请给出至少含一个记录的文件夹或文件",
    ],
    [
        "there is no element called {name}; the elements are {known}",
        "es gibt kein Element {name}; die Elemente sind {known}",
        "il n’y a pas d’élément {name} ; les éléments sont {known}",
        "没有名为 {name} 的元件；元件有 {known}",
    ],
    [
        "fit does not identify {name}: it is added to a fitted model where dashpot diagnose finds it, or by hand; fit can use {known}",
        "fit identifiziert {name} nicht: dashpot diagnose fügt es einem angepassten Modell hinzu, wo es gefunden wird, oder man tut es von Hand; fit kennt {known}",
        "fit n’identifie pas {name} : dashpot diagnose l’ajoute au modèle ajusté où il le trouve, sinon à la main ; fit connaît {known}",
        "fit 不辨识 {name}：由 dashpot diagnose 找到后加入已拟合的模型，或手工加入；fit 可用 {known}",
    ],
    [
        "{name} is a model of its own and takes no other element; use --model lag",
        "{name} ist ein eigenes Modell und nimmt kein anderes Element auf; --model lag verwenden",
        "{name} est un modèle à part et n’admet aucun autre élément ; utiliser --model lag",
        "{name} 是独立的模型，不接受其他元件；请使用 --model lag",
    ],
    [
        "the tests never move in {direction}: a force-velocity curve needs both directions",
        "die Versuche bewegen sich nie in Richtung {direction}: eine Kraft-Geschwindigkeits-Kurve braucht beide Richtungen",
        "les essais ne bougent jamais en {direction} : une courbe effort-vitesse demande les deux sens",
        "试验从未向{direction}方向运动：力—速度曲线需要两个方向",
    ],
    [
        "no finite force could be computed for test {test}; look at its channels (a jump in displacement?)",
        "für den Versuch {test} ließ sich keine endliche Kraft berechnen; seine Kanäle ansehen (ein Sprung im Weg?)",
        "aucun effort fini n’a pu être calculé pour l’essai {test} ; regarder ses voies (un saut du déplacement ?)",
        "试验 {test} 无法算出有限的力；请查看其通道（位移有跳变？）",
    ],
    // Kinds of tests.
    ["slow tests", "langsame Versuche", "essais lents", "慢速试验"],
    ["small strokes", "kleine Hübe", "petites courses", "小行程"],
    ["large strokes", "große Hübe", "grandes courses", "大行程"],
    [
        "{name} was expected at {value} {unit} (95 %: {low} to {high}), by the dimensions of the damper: {facts}",
        "{name} wurde nach den Maßen des Dämpfers ({facts}) bei {value} {unit} erwartet (95 %: {low} bis {high})",
        "{name} était attendu à {value} {unit} (95 % : {low} à {high}) d’après les dimensions de l’amortisseur : {facts}",
        "根据减振器的尺寸（{facts}），{name} 预期为 {value} {unit}（95 %：{low} 至 {high}）",
    ],
    [
        "{name} contradicts the dimensions of the damper: {value} {unit} are {ratio} times the {expected} {unit} that {facts} give",
        "{name} widerspricht den Maßen des Dämpfers: {value} {unit} sind das {ratio}-Fache der {expected} {unit}, die aus {facts} folgen",
        "{name} contredit les dimensions de l’amortisseur : {value} {unit}, soit {ratio} fois les {expected} {unit} que donnent {facts}",
        "{name} 与减振器的尺寸矛盾：{value} {unit} 是由 {facts} 得出的 {expected} {unit} 的 {ratio} 倍",
    ],
    [
        "no temperature was recorded in all tests: gas that warms through a campaign lets the force at rest fall as well. The temperature tells the two apart",
        "nicht in allen Versuchen wurde eine Temperatur aufgezeichnet: Gas, das sich während der Messreihe erwärmt, lässt die Kraft in Ruhe ebenso fallen. Die Temperatur trennt beides",
        "aucune température n’a été enregistrée dans tous les essais : un gaz qui chauffe au fil de la campagne fait aussi baisser l’effort au repos. La température les distingue",
        "并非所有试验都记录了温度：气体在测试过程中升温同样会使静止力下降。温度可以区分二者",
    ],
    [
        "gas_force is that at {temperature} °C, the middle of the temperatures that were measured; by gas_warming_rate it grows with them",
        "gas_force gilt bei {temperature} °C, der Mitte der gemessenen Temperaturen; mit gas_warming_rate wächst sie mit ihnen",
        "gas_force vaut à {temperature} °C, milieu des températures mesurées ; avec gas_warming_rate il croît avec elles",
        "gas_force 为 {temperature} °C（实测温度范围的中点）时的值；按 gas_warming_rate 随温度增大",
    ],
];
