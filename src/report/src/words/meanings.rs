//! What elements and parameters mean, in the other languages: the kernel's own English text, then German, French and Chinese.
//!
//! Names of forms such as `bypass` stand in model files and are not translated.

use super::{Language, Words};

/// One meaning: English, German, French, Chinese.
type Meaning = [&'static str; 4];

impl Words {
    /// What an element or a parameter means, in this language.
    pub fn meaning(&self, english: &'static str) -> &'static str {
        let language = Language::ALL.iter().position(|(code, _)| *code == self.code);
        let found = MEANINGS.iter().find(|meaning| meaning[0] == english);
        found.zip(language).map_or(english, |(meaning, language)| meaning[language])
    }
}

/// In the order in which the kernel lists them.
const MEANINGS: &[Meaning] = &[
    [
        "primary damper: the force-velocity (FV) curve",
        "Grunddämpfer: die Kraft-Geschwindigkeits-Kurve (FV-Kurve)",
        "amortisseur de base : la courbe effort-vitesse (FV)",
        "主减振器：力—速度（FV）曲线",
    ],
    [
        "series spring and damper with the internal mass (compressibility of gas, oil and mount)",
        "Feder und Dämpfer in Reihe mit der inneren Masse (Nachgiebigkeit von Gas, Öl und Lager)",
        "ressort et amortisseur en série avec la masse interne (souplesse du gaz, de l’huile et de l’articulation)",
        "串联弹簧和阻尼及内部质量（气体、油液和支座的可压缩性）",
    ],
    [
        "free play in an eye or mount; needs series_compliance",
        "Spiel in einem Auge oder Lager; braucht series_compliance",
        "jeu dans un œillet ou une articulation ; demande series_compliance",
        "吊环或支座中的间隙；需要 series_compliance",
    ],
    [
        "rubber in line with the damper: the series spring hardens and loses energy; needs series_compliance",
        "Gummi in Reihe mit dem Dämpfer: die Reihenfeder wird härter und verliert Energie; braucht series_compliance",
        "caoutchouc en série avec l’amortisseur : le ressort en série durcit et perd de l’énergie ; demande series_compliance",
        "与减振器串联的橡胶：串联弹簧变硬并耗散能量；需要 series_compliance",
    ],
    [
        "compressibility of the oil column (with the expansion of the cylinder) before the valves",
        "Nachgiebigkeit der Ölsäule (mit der Aufweitung des Zylinders) vor den Ventilen",
        "compressibilité de la colonne d’huile (avec la dilatation du cylindre) devant les clapets",
        "阀前油柱的可压缩性（含缸筒膨胀）",
    ],
    [
        "air in the oil: the oil column is soft while the force is small",
        "Luft im Öl: die Ölsäule ist weich, solange die Kraft klein ist",
        "air dans l’huile : la colonne d’huile est souple tant que l’effort est petit",
        "油中有空气：力小时油柱偏软",
    ],
    [
        "cavitation: the hydraulic force of one stroke is capped, and a void remains to be closed",
        "Kavitation: die hydraulische Kraft einer Richtung ist begrenzt, und ein Hohlraum muss erst wieder geschlossen werden",
        "cavitation : l’effort hydraulique d’une course est plafonné et un vide reste à refermer",
        "空化：一个行程方向的液压力被限制，留下的空穴需要先闭合",
    ],
    [
        "damping that is weaker (bypass) or firmer over a part of the stroke",
        "Dämpfung, die über einen Teil des Hubs schwächer (Bypass) oder straffer ist",
        "amortissement plus faible (dérivation) ou plus ferme sur une partie de la course",
        "在部分行程上较弱（旁通）或较强的阻尼",
    ],
    [
        "damping that falls with the temperature of the oil, measured or by its own heat",
        "Dämpfung, die mit der Temperatur des Öls fällt, gemessen oder durch die eigene Wärme",
        "amortissement qui baisse avec la température de l’huile, mesurée ou due à sa propre chaleur",
        "随油温（实测或自身发热）下降的阻尼",
    ],
    [
        "damping that is weaker in fast strokes than in slow ones of the same speed",
        "Dämpfung, die in schnellen Hüben schwächer ist als in langsamen gleicher Geschwindigkeit",
        "amortissement plus faible dans les courses rapides que dans les lentes de même vitesse",
        "速度相同时，高频行程中的阻尼弱于低频行程",
    ],
    [
        "blow-off valve that opens late and closes late: more force while speed rises",
        "Überdruckventil, das spät öffnet und spät schließt: mehr Kraft bei steigender Geschwindigkeit",
        "clapet de décharge qui s’ouvre tard et se ferme tard : plus d’effort quand la vitesse croît",
        "卸荷阀开得晚、关得晚：速度上升时力较大",
    ],
    [
        "spring parallel to the primary damper: linear, quadratic, cubic, quartic or lookup",
        "Feder parallel zum Grunddämpfer: linear, quadratisch, kubisch, vierten Grades oder als Tabelle",
        "ressort en parallèle avec l’amortisseur de base : linéaire, quadratique, cubique, du quatrième degré ou en table",
        "与主减振器并联的弹簧：线性、二次、三次、四次或查表",
    ],
    [
        "dry friction of constant level, F_s tanh(K v)",
        "Trockenreibung konstanter Höhe, F_s tanh(K v)",
        "frottement sec de niveau constant, F_s tanh(K v)",
        "恒定水平的干摩擦，F_s tanh(K v)",
    ],
    [
        "dry friction with a break-away peak",
        "Trockenreibung mit Losbrechspitze",
        "frottement sec avec pointe de décollement",
        "带起动峰值的干摩擦",
    ],
    ["viscous friction, F_v v|v|", "viskose Reibung, F_v v|v|", "frottement visqueux, F_v v|v|", "黏性摩擦，F_v v|v|"],
    [
        "dry friction proportional to side force",
        "Trockenreibung proportional zur Seitenkraft",
        "frottement sec proportionnel à l’effort latéral",
        "与侧向力成正比的干摩擦",
    ],
    ["constant gas force", "konstante Gaskraft", "effort du gaz constant", "恒定气体力"],
    [
        "gas force that grows with the temperature of the damper",
        "Gaskraft, die mit der Temperatur des Dämpfers wächst",
        "effort du gaz qui croît avec la température de l’amortisseur",
        "随减振器温度增大的气体力",
    ],
    [
        "polynomial FV curve with a first-order lag whose time constant ramps with speed",
        "FV-Kurve als Polynom mit Verzögerung erster Ordnung, deren Zeitkonstante mit der Geschwindigkeit übergeht",
        "courbe FV polynomiale avec un retard du premier ordre dont la constante de temps varie avec la vitesse",
        "多项式 FV 曲线，带一阶滞后，其时间常数随速度变化",
    ],
    [
        "friction that turns over within a short travel after each reversal (Dahl)",
        "Reibung, die nach jeder Umkehr innerhalb eines kurzen Wegs umschlägt (Dahl)",
        "frottement qui se retourne sur un court trajet après chaque inversion (Dahl)",
        "每次换向后在短位移内反转的摩擦（Dahl）",
    ],
    [
        "growth of the gas force with the displacement of the rod, slow to fast",
        "Zunahme der Gaskraft mit dem Weg der Stange, langsam bis schnell",
        "croissance de l’effort du gaz avec le déplacement de la tige, de lent à rapide",
        "气体力随活塞杆位移的增长，由慢到快",
    ],
    [
        "mass moved by the driven end, between load cell and damper, or by the piston",
        "vom bewegten Ende zwischen Kraftmessdose und Dämpfer oder vom Kolben bewegte Masse",
        "masse mue par l’extrémité entraînée, entre capteur d’effort et amortisseur, ou par le piston",
        "由驱动端（力传感器与减振器之间）或活塞带动的质量",
    ],
    [
        "stop at the end of the compression stroke, rubber or hydraulic",
        "Anschlag am Ende der Druckstufe, Gummi oder hydraulisch",
        "butée en fin de compression, caoutchouc ou hydraulique",
        "压缩行程末端的限位，橡胶或液压",
    ],
    [
        "stop at the end of the rebound stroke, rubber or hydraulic",
        "Anschlag am Ende der Zugstufe, Gummi oder hydraulisch",
        "butée en fin de détente, caoutchouc ou hydraulique",
        "复原行程末端的限位，橡胶或液压",
    ],
    [
        "settings of the fixed-step integration",
        "Einstellungen der Integration mit fester Schrittweite",
        "réglages de l’intégration à pas fixe",
        "定步长积分的设置",
    ],
    [
        "FV curve from the table or from slopes and knees",
        "FV-Kurve aus der Tabelle oder aus Steigungen und Knicken",
        "courbe FV de la table, ou de pentes et de coudes",
        "FV 曲线取自表格，或由斜率和拐点给出",
    ],
    [
        "how the FV table runs between its points",
        "Verlauf der FV-Tabelle zwischen ihren Punkten",
        "allure de la table FV entre ses points",
        "FV 表在各点之间的走向",
    ],
    [
        "velocities of the FV table, rebound positive, increasing",
        "Geschwindigkeiten der FV-Tabelle, Zugstufe positiv, steigend",
        "vitesses de la table FV, détente positive, croissantes",
        "FV 表的速度，复原为正，递增",
    ],
    [
        "forces of the FV table, tension positive, non-decreasing",
        "Kräfte der FV-Tabelle, Zugkraft positiv, nicht fallend",
        "efforts de la table FV, traction positive, non décroissants",
        "FV 表的力，拉力为正，不递减",
    ],
    [
        "Cr1: rebound slope below the first knee",
        "Cr1: Steigung der Zugstufe unter dem ersten Knick",
        "Cr1 : pente en détente sous le premier coude",
        "Cr1：第一拐点以下的复原斜率",
    ],
    [
        "Cr2: rebound slope between the knees",
        "Cr2: Steigung der Zugstufe zwischen den Knicken",
        "Cr2 : pente en détente entre les coudes",
        "Cr2：两拐点之间的复原斜率",
    ],
    [
        "Cr3: rebound slope above the second knee",
        "Cr3: Steigung der Zugstufe über dem zweiten Knick",
        "Cr3 : pente en détente au-dessus du second coude",
        "Cr3：第二拐点以上的复原斜率",
    ],
    ["first rebound knee", "erster Knick der Zugstufe", "premier coude en détente", "复原第一拐点"],
    ["second rebound knee", "zweiter Knick der Zugstufe", "second coude en détente", "复原第二拐点"],
    [
        "Cc1: compression slope below the knee",
        "Cc1: Steigung der Druckstufe unter dem Knick",
        "Cc1 : pente en compression sous le coude",
        "Cc1：拐点以下的压缩斜率",
    ],
    [
        "Cc2: compression slope above the knee",
        "Cc2: Steigung der Druckstufe über dem Knick",
        "Cc2 : pente en compression au-dessus du coude",
        "Cc2：拐点以上的压缩斜率",
    ],
    [
        "compression knee, as a speed",
        "Knick der Druckstufe, als Geschwindigkeitsbetrag",
        "coude en compression, en valeur absolue de la vitesse",
        "压缩拐点，以速率计",
    ],
    [
        "stiffness of the series spring, k_s",
        "Steifigkeit der Reihenfeder, k_s",
        "raideur du ressort en série, k_s",
        "串联弹簧刚度，k_s",
    ],
    [
        "damping beside the series spring, c_s",
        "Dämpfung neben der Reihenfeder, c_s",
        "amortissement à côté du ressort en série, c_s",
        "串联弹簧旁的阻尼，c_s",
    ],
    [
        "moving mass of rod, oil and gas, m",
        "bewegte Masse von Stange, Öl und Gas, m",
        "masse mobile de tige, huile et gaz, m",
        "活塞杆、油液和气体的运动质量，m",
    ],
    [
        "what the series spring carries: the hydraulic force and the springs on the mass, or friction and gas force too, as an eye or a mount does",
        "was die Reihenfeder trägt: die hydraulische Kraft und die Federn an der Masse, oder auch Reibung und Gaskraft, wie ein Auge oder Lager",
        "ce que porte le ressort en série : l’effort hydraulique et les ressorts sur la masse, ou aussi frottement et effort du gaz, comme un œillet ou une articulation",
        "串联弹簧承受的力：作用于质量的液压力和弹簧力，或者还包括摩擦力和气体力（如吊环或支座）",
    ],
    [
        "free travel from contact to contact, 2 g",
        "freier Weg von Anlage zu Anlage, 2 g",
        "course libre de contact à contact, 2 g",
        "从一侧接触到另一侧接触的自由行程，2 g",
    ],
    [
        "force at which the gap is half closed, F_0: softness of the contact",
        "Kraft, bei der das Spiel halb geschlossen ist, F_0: Weichheit der Anlage",
        "effort auquel le jeu est à moitié refermé, F_0 : souplesse du contact",
        "间隙闭合一半时的力，F_0：接触的柔软程度",
    ],
    [
        "force in the middle of the gap, F_1: weight on the eye, gas force that it carries, clamping",
        "Kraft in der Mitte des Spiels, F_1: Gewicht am Auge, Gaskraft, die es trägt, Verspannung",
        "effort au milieu du jeu, F_1 : poids sur l’œillet, effort du gaz qu’il porte, serrage",
        "间隙中点处的力，F_1：吊环上的重量、所承受的气体力、夹紧力",
    ],
    [
        "deflection at which the series spring has doubled its force, d_h",
        "Einfederung, bei der die Reihenfeder die doppelte Kraft hat, d_h",
        "flexion à laquelle le ressort en série a doublé son effort, d_h",
        "串联弹簧力达到线性值两倍时的变形，d_h",
    ],
    [
        "share of the series stiffness that fast or small motion adds, k_1/k_s",
        "Anteil der Reihensteifigkeit, den schnelle oder kleine Bewegung hinzufügt, k_1/k_s",
        "part de la raideur en série que le mouvement rapide ou petit ajoute, k_1/k_s",
        "快速或小幅运动所增加的刚度占串联刚度的比例，k_1/k_s",
    ],
    [
        "time in which that share gives way, tau",
        "Zeit, in der dieser Anteil nachgibt, tau",
        "temps dans lequel cette part cède, tau",
        "该部分松弛的时间，tau",
    ],
    [
        "deflection in which that share gives way by friction, d_f; large: by time alone",
        "Einfederung, in der dieser Anteil durch Reibung nachgibt, d_f; groß: allein durch Zeit",
        "flexion dans laquelle cette part cède par frottement, d_f ; grande : par le temps seul",
        "该部分因摩擦松弛的变形，d_f；很大时仅随时间松弛",
    ],
    [
        "deflection at which the rubber meets a stop, to either side, L",
        "Einfederung, bei der der Gummi nach jeder Seite einen Anschlag trifft, L",
        "flexion à laquelle le caoutchouc rencontre une butée, de chaque côté, L",
        "橡胶在任一侧碰到限位时的变形，L",
    ],
    [
        "share of the series stiffness that the stop adds, k_e/k_s; 0: no stop",
        "Anteil der Reihensteifigkeit, den der Anschlag hinzufügt, k_e/k_s; 0: kein Anschlag",
        "part de la raideur en série que la butée ajoute, k_e/k_s ; 0 : pas de butée",
        "限位所增加的刚度占串联刚度的比例，k_e/k_s；0：无限位",
    ],
    [
        "share of the series stiffness that gives way slowly, k_2/k_s",
        "Anteil der Reihensteifigkeit, der langsam nachgibt, k_2/k_s",
        "part de la raideur en série qui cède lentement, k_2/k_s",
        "缓慢松弛的刚度占串联刚度的比例，k_2/k_s",
    ],
    [
        "time in which that share gives way, tau_2",
        "Zeit, in der dieser Anteil nachgibt, tau_2",
        "temps dans lequel cette part cède, tau_2",
        "该部分松弛的时间，tau_2",
    ],
    [
        "stiffness of the oil column at x = 0, cylinder expansion included, k_o",
        "Steifigkeit der Ölsäule bei x = 0, Aufweitung des Zylinders eingeschlossen, k_o",
        "raideur de la colonne d’huile en x = 0, dilatation du cylindre comprise, k_o",
        "x = 0 处油柱刚度（含缸筒膨胀），k_o",
    ],
    [
        "one over the length of the column at x = 0, lambda; 0: the same stiffness at every place",
        "Kehrwert der Länge der Säule bei x = 0, lambda; 0: überall gleiche Steifigkeit",
        "inverse de la longueur de la colonne en x = 0, lambda ; 0 : même raideur partout",
        "x = 0 处油柱长度的倒数，lambda；0：各处刚度相同",
    ],
    [
        "whose column yields: that of the rebound chamber, or that of the chamber under pressure",
        "welche Säule nachgibt: die der Zugkammer oder die der Kammer unter Druck",
        "quelle colonne cède : celle de la chambre de détente, ou celle de la chambre sous pression",
        "哪一油柱变形：复原腔的，或受压腔的",
    ],
    [
        "stiffness of the column in compression, as a share of that in rebound, r_o",
        "Steifigkeit der Säule in der Druckstufe, als Anteil der in der Zugstufe, r_o",
        "raideur de la colonne en compression, rapportée à celle en détente, r_o",
        "压缩时油柱刚度与复原时之比，r_o",
    ],
    [
        "stroke that the air takes up in rebound, d_a",
        "Weg, den die Luft in der Zugstufe aufnimmt, d_a",
        "course que l’air absorbe en détente, d_a",
        "复原时空气吸收的行程，d_a",
    ],
    [
        "force at which half of that stroke is taken, F_a",
        "Kraft, bei der die Hälfte dieses Wegs aufgenommen ist, F_a",
        "effort auquel la moitié de cette course est absorbée, F_a",
        "该行程被吸收一半时的力，F_a",
    ],
    [
        "stroke that the air takes up in compression, as a share of that in rebound, r_a",
        "Weg, den die Luft in der Druckstufe aufnimmt, als Anteil des Wegs in der Zugstufe, r_a",
        "course que l’air absorbe en compression, rapportée à celle en détente, r_a",
        "压缩时空气吸收的行程与复原时之比，r_a",
    ],
    [
        "largest hydraulic force of that stroke, C",
        "größte hydraulische Kraft dieser Richtung, C",
        "plus grand effort hydraulique de cette course, C",
        "该行程方向的最大液压力，C",
    ],
    [
        "stroke whose force is capped",
        "Richtung, deren Kraft begrenzt ist",
        "course dont l’effort est plafonné",
        "力被限制的行程方向",
    ],
    [
        "share of the cap that stays on the return while the void closes: 1 gas pushes on, 0 dead stroke",
        "Anteil der Grenzkraft, der auf dem Rückweg bleibt, während der Hohlraum sich schließt: 1 Gas drückt weiter, 0 Leerweg",
        "part du plafond qui demeure au retour pendant que le vide se referme : 1 le gaz continue de pousser, 0 course morte",
        "返程中空穴闭合时保留的限力比例：1 气体继续推，0 空行程",
    ],
    [
        "void by the limited force of that stroke, or by a foot valve that does not refill the chamber behind it",
        "Hohlraum durch die begrenzte Kraft dieser Richtung oder durch ein Bodenventil, das die Kammer dahinter nicht nachfüllt",
        "vide par l’effort limité de cette course, ou par un clapet de pied qui ne remplit pas la chambre derrière lui",
        "空穴来自该行程的限力，或来自底阀未能补充其后的腔室",
    ],
    [
        "foot valve: speed of that stroke beyond which the chamber is not refilled, v_f",
        "Bodenventil: Geschwindigkeit dieser Richtung, über der die Kammer nicht nachgefüllt wird, v_f",
        "clapet de pied : vitesse de cette course au-delà de laquelle la chambre n’est plus remplie, v_f",
        "底阀：超过该速度腔室不再被充满，v_f",
    ],
    [
        "foot valve: share of the flow beyond that speed that is missing, a",
        "Bodenventil: Anteil des Stroms über dieser Geschwindigkeit, der fehlt, a",
        "clapet de pied : part du débit au-delà de cette vitesse qui manque, a",
        "底阀：超过该速度的流量中缺失的比例，a",
    ],
    [
        "cap: share of it at which the void opens, alpha; 1: at the cap itself",
        "Grenzkraft: Anteil davon, bei dem der Hohlraum sich öffnet, alpha; 1: bei der Grenzkraft selbst",
        "plafond : part de celui-ci à laquelle le vide s’ouvre, alpha ; 1 : au plafond même",
        "限力：空穴在其多大比例时出现，alpha；1：恰在限力处",
    ],
    [
        "cap: void over which half of the rest is gained as its gas expands, e_1",
        "Grenzkraft: Hohlraum, über den die Hälfte des Rests gewonnen wird, während sein Gas sich ausdehnt, e_1",
        "plafond : vide sur lequel la moitié du reste est gagnée pendant que son gaz se détend, e_1",
        "限力：空穴中气体膨胀、获得其余一半力时的空穴长度，e_1",
    ],
    [
        "share of the FV force that is missing in the zone, a; negative: a firmer zone",
        "Anteil der FV-Kraft, der in der Zone fehlt, a; negativ: eine straffere Zone",
        "part de l’effort FV qui manque dans la zone, a ; négative : une zone plus ferme",
        "区域内缺失的 FV 力比例，a；负值：较强的区域",
    ],
    [
        "displacement at the middle of the zone, c",
        "Weg in der Mitte der Zone, c",
        "déplacement au milieu de la zone, c",
        "区域中点的位移，c",
    ],
    ["half the length of the zone, w", "halbe Länge der Zone, w", "demi-longueur de la zone, w", "区域长度的一半，w"],
    [
        "length over which the zone fades out, b",
        "Länge, über die die Zone ausläuft, b",
        "longueur sur laquelle la zone s’estompe, b",
        "区域过渡的长度，b",
    ],
    [
        "strokes on which it acts",
        "Richtungen, in denen es wirkt",
        "courses sur lesquelles elle agit",
        "起作用的行程方向",
    ],
    [
        "factor on the FV force, or flow beside the valves",
        "Faktor auf die FV-Kraft oder Strom neben den Ventilen",
        "facteur sur l’effort FV, ou débit à côté des clapets",
        "FV 力的系数，或阀旁的流量",
    ],
    [
        "groove: piston velocity that flows past at a hydraulic force of 1 kN in the zone, q_b",
        "Nut: Kolbengeschwindigkeit, die in der Zone bei einer hydraulischen Kraft von 1 kN vorbeiströmt, q_b",
        "rainure : vitesse de piston qui passe à côté pour un effort hydraulique de 1 kN dans la zone, q_b",
        "槽：区域内液压力为 1 kN 时旁流所对应的活塞速度，q_b",
    ],
    [
        "temperature as given, or as the surroundings' plus the rise by the damper's own heat",
        "Temperatur wie gegeben, oder die der Umgebung und der Anstieg durch die eigene Wärme des Dämpfers",
        "température donnée, ou celle de l’ambiance plus l’échauffement propre de l’amortisseur",
        "温度取给定值，或环境温度加减振器自身发热的温升",
    ],
    [
        "fall of the damping per kelvin, alpha",
        "Abfall der Dämpfung je Kelvin, alpha",
        "baisse de l’amortissement par kelvin, alpha",
        "每开尔文阻尼的下降，alpha",
    ],
    [
        "temperature of the FV curve, T_0",
        "Temperatur der FV-Kurve, T_0",
        "température de la courbe FV, T_0",
        "FV 曲线的温度，T_0",
    ],
    [
        "heat capacity of oil and body, C_h",
        "Wärmekapazität von Öl und Gehäuse, C_h",
        "capacité thermique de l’huile et du corps, C_h",
        "油液和壳体的热容，C_h",
    ],
    [
        "heat given to the surroundings per kelvin, h",
        "je Kelvin an die Umgebung abgegebene Wärme, h",
        "chaleur cédée à l’ambiance par kelvin, h",
        "每开尔文向环境的散热，h",
    ],
    [
        "force at which half of it still is laminar and fades, F_l; large: all of it fades",
        "Kraft, bei der die Hälfte davon noch laminar ist und nachlässt, F_l; groß: alles lässt nach",
        "effort auquel la moitié est encore laminaire et baisse, F_l ; grand : tout baisse",
        "一半仍为层流并衰减时的力，F_l；很大时全部衰减",
    ],
    [
        "how soon the fall per kelvin gets smaller, kappa; 0: exponential, 1/(T_0 + 95 degC): Vogel's law",
        "wie bald der Abfall je Kelvin kleiner wird, kappa; 0: exponentiell, 1/(T_0 + 95 degC): Gesetz von Vogel",
        "à quelle allure la baisse par kelvin diminue, kappa ; 0 : exponentielle, 1/(T_0 + 95 degC) : loi de Vogel",
        "每开尔文的下降变小的快慢，kappa；0：指数，1/(T_0 + 95 degC)：Vogel 定律",
    ],
    [
        "lagging share, share that returns within each stroke, or flow beside the valves that ends within each stroke",
        "nacheilender Anteil, Anteil, der in jedem Hub wiederkehrt, oder Strom neben den Ventilen, der in jedem Hub endet",
        "part en retard, part qui revient dans chaque course, ou débit à côté des clapets qui cesse dans chaque course",
        "滞后的部分、在每个行程内恢复的部分，或在每个行程内终止的阀旁流量",
    ],
    [
        "share of the force that fast strokes lose, a",
        "Anteil der Kraft, den schnelle Hübe verlieren, a",
        "part de l’effort que perdent les courses rapides, a",
        "快速行程损失的力的比例，a",
    ],
    [
        "time that tells fast from slow, tau",
        "Zeit, die schnell von langsam scheidet, tau",
        "temps qui sépare le rapide du lent, tau",
        "区分快慢的时间，tau",
    ],
    [
        "stroke form: speed that fills the control chamber, u_0",
        "Form „stroke“: Geschwindigkeit, die die Steuerkammer füllt, u_0",
        "forme « stroke » : vitesse qui remplit la chambre de commande, u_0",
        "stroke 形式：充满控制腔的速度，u_0",
    ],
    [
        "bypass form: piston velocity that flows past at a hydraulic force of 1 kN, q_s",
        "Form „bypass“: Kolbengeschwindigkeit, die bei einer hydraulischen Kraft von 1 kN vorbeiströmt, q_s",
        "forme « bypass » : vitesse de piston qui passe à côté pour un effort hydraulique de 1 kN, q_s",
        "bypass 形式：液压力为 1 kN 时旁流所对应的活塞速度，q_s",
    ],
    [
        "bypass form: hydraulic force above which the control chamber fills at its full rate, F_0",
        "Form „bypass“: hydraulische Kraft, über der die Steuerkammer sich mit voller Rate füllt, F_0",
        "forme « bypass » : effort hydraulique au-dessus duquel la chambre de commande se remplit à plein débit, F_0",
        "bypass 形式：超过该液压力控制腔以全速充满，F_0",
    ],
    [
        "bypass form: hydraulic force below which its flow is laminar, F_l",
        "Form „bypass“: hydraulische Kraft, unter der ihre Strömung laminar ist, F_l",
        "forme « bypass » : effort hydraulique au-dessous duquel son écoulement est laminaire, F_l",
        "bypass 形式：低于该液压力时其流动为层流，F_l",
    ],
    [
        "opening form: share of the force that lateness adds, eta",
        "Form „opening“: Anteil der Kraft, den die Verspätung hinzufügt, eta",
        "forme « opening » : part de l’effort que le retard ajoute, eta",
        "opening 形式：滞后所增加的力的比例，eta",
    ],
    [
        "force at which the valve opens",
        "Kraft, bei der das Ventil öffnet",
        "effort auquel le clapet s’ouvre",
        "阀开启时的力",
    ],
    [
        "opening form: force at which it closes over that at which it opens; 1: the time alone makes it late",
        "Form „opening“: Kraft, bei der es schließt, über der, bei der es öffnet; 1: allein die Zeit macht es spät",
        "forme « opening » : effort de fermeture sur effort d’ouverture ; 1 : le temps seul le retarde",
        "opening 形式：关闭力与开启力之比；1：仅由时间造成滞后",
    ],
    [
        "time in which it moves, tau; spool: over 2 pi that of its swing",
        "Zeit, in der es sich bewegt, tau; Schieber: die seiner Schwingung durch 2 pi",
        "temps dans lequel il se meut, tau ; tiroir : période de son oscillation sur 2 pi",
        "其运动的时间，tau；滑阀：振荡周期除以 2 pi",
    ],
    [
        "force over which it opens, b",
        "Kraft, über die es öffnet, b",
        "effort sur lequel il s’ouvre, b",
        "开启过程所经历的力的范围，b",
    ],
    [
        "one opening that comes and goes late, or a valve that lags at every opening by friction or by its mass",
        "eine Öffnung, die spät kommt und geht, oder ein Ventil, das bei jeder Öffnung durch Reibung oder seine Masse nacheilt",
        "une ouverture qui vient et part tard, ou un clapet en retard à toute ouverture par frottement ou par sa masse",
        "一次开启得晚、关闭得晚，或在任何开度下因摩擦或自身质量而滞后的阀",
    ],
    [
        "play form: force that the valve does not follow, P",
        "Form „play“: Kraft, der das Ventil nicht folgt, P",
        "forme « play » : effort que le clapet ne suit pas, P",
        "play 形式：阀不跟随的力，P",
    ],
    [
        "spool form: damping ratio, zeta",
        "Form „spool“: Dämpfungsmaß, zeta",
        "forme « spool » : taux d’amortissement, zeta",
        "spool 形式：阻尼比，zeta",
    ],
    ["k_p of k_p x", "k_p in k_p x", "k_p de k_p x", "k_p x 中的 k_p"],
    ["k_p of k_p x|x|", "k_p in k_p x|x|", "k_p de k_p x|x|", "k_p x|x| 中的 k_p"],
    ["k_p of k_p x^3", "k_p in k_p x^3", "k_p de k_p x^3", "k_p x^3 中的 k_p"],
    ["k_p of k_p x^3|x|", "k_p in k_p x^3|x|", "k_p de k_p x^3|x|", "k_p x^3|x| 中的 k_p"],
    [
        "displacements of the lookup spring, increasing; empty: no lookup",
        "Wege der Tabellenfeder, steigend; leer: keine Tabelle",
        "déplacements du ressort en table, croissants ; vide : pas de table",
        "查表弹簧的位移，递增；空：不查表",
    ],
    [
        "forces of the lookup spring, non-decreasing",
        "Kräfte der Tabellenfeder, nicht fallend",
        "efforts du ressort en table, non décroissants",
        "查表弹簧的力，不递减",
    ],
    ["friction level, F_s", "Höhe der Reibung, F_s", "niveau du frottement, F_s", "摩擦力水平，F_s"],
    [
        "steepness of the change of sign, K",
        "Steilheit des Vorzeichenwechsels, K",
        "raideur du changement de signe, K",
        "换向的陡度，K",
    ],
    [
        "which of the two Stribeck forms",
        "welche der beiden Stribeck-Formen",
        "laquelle des deux formes de Stribeck",
        "两种 Stribeck 形式中的哪一种",
    ],
    [
        "peak (transition) force, F_brk or F_t",
        "Spitzenkraft (Übergangskraft), F_brk oder F_t",
        "effort de pointe (de transition), F_brk ou F_t",
        "峰值（过渡）力，F_brk 或 F_t",
    ],
    [
        "level after the peak, F_c or F_s",
        "Höhe nach der Spitze, F_c oder F_s",
        "niveau après la pointe, F_c ou F_s",
        "峰值之后的水平，F_c 或 F_s",
    ],
    [
        "velocity of the peak, v_brk or V_fs",
        "Geschwindigkeit der Spitze, v_brk oder V_fs",
        "vitesse de la pointe, v_brk ou V_fs",
        "峰值处的速度，v_brk 或 V_fs",
    ],
    [
        "full form: velocity scale of the fall, V_s",
        "volle Form: Geschwindigkeitsmaß des Abfalls, V_s",
        "forme complète : échelle de vitesse de la chute, V_s",
        "完整形式：下降的速度尺度，V_s",
    ],
    [
        "full form: exponent of the fall, a (1 Tustin, 2 Gauss)",
        "volle Form: Exponent des Abfalls, a (1 Tustin, 2 Gauß)",
        "forme complète : exposant de la chute, a (1 Tustin, 2 Gauss)",
        "完整形式：下降的指数，a（1 Tustin，2 Gauss）",
    ],
    [
        "full form: how near F_t the peak comes, c",
        "volle Form: wie nahe die Spitze an F_t kommt, c",
        "forme complète : de combien la pointe approche F_t, c",
        "完整形式：峰值接近 F_t 的程度，c",
    ],
    [
        "full form: exponent of the rise, d",
        "volle Form: Exponent des Anstiegs, d",
        "forme complète : exposant de la montée, d",
        "完整形式：上升的指数，d",
    ],
    ["F_v of F_v v|v|", "F_v in F_v v|v|", "F_v de F_v v|v|", "F_v v|v| 中的 F_v"],
    [
        "friction per side force, k_avg",
        "Reibung je Seitenkraft, k_avg",
        "frottement par effort latéral, k_avg",
        "单位侧向力的摩擦力，k_avg",
    ],
    [
        "gas force, positive where it pushes the rod out",
        "Gaskraft, positiv, wo sie die Stange hinausdrückt",
        "effort du gaz, positif s’il pousse la tige dehors",
        "气体力，把活塞杆推出为正",
    ],
    [
        "growth of the gas force per kelvin, c",
        "Zuwachs der Gaskraft je Kelvin, c",
        "accroissement de l’effort du gaz par kelvin, c",
        "每开尔文的气体力增量，c",
    ],
    [
        "temperature at which the gas force is that of the other elements, T_0",
        "Temperatur, bei der die Gaskraft die der anderen Elemente ist, T_0",
        "température à laquelle l’effort du gaz est celui des autres éléments, T_0",
        "气体力等于其他元件给出值时的温度，T_0",
    ],
    [
        "coefficients of v^0, v^1, ...",
        "Koeffizienten von v^0, v^1, ...",
        "coefficients de v^0, v^1, ...",
        "v^0、v^1、... 的系数",
    ],
    [
        "time constant at low speed",
        "Zeitkonstante bei kleiner Geschwindigkeit",
        "constante de temps à basse vitesse",
        "低速时的时间常数",
    ],
    [
        "time constant at high speed",
        "Zeitkonstante bei großer Geschwindigkeit",
        "constante de temps à haute vitesse",
        "高速时的时间常数",
    ],
    [
        "speed at which the time constant starts to change",
        "Geschwindigkeit, ab der die Zeitkonstante sich ändert",
        "vitesse à laquelle la constante de temps commence à changer",
        "时间常数开始变化的速度",
    ],
    [
        "speed at which it has changed",
        "Geschwindigkeit, bei der sie sich geändert hat",
        "vitesse à laquelle elle a changé",
        "时间常数变化完毕的速度",
    ],
    [
        "friction level after long travel, F_c",
        "Höhe der Reibung nach langem Weg, F_c",
        "niveau du frottement après un long trajet, F_c",
        "长位移之后的摩擦力水平，F_c",
    ],
    [
        "travel in which the force approaches its level by a factor e, z_0",
        "Weg, auf dem die Kraft sich ihrer Höhe um den Faktor e nähert, z_0",
        "trajet dans lequel l’effort approche son niveau d’un facteur e, z_0",
        "力以因子 e 接近其水平所需的位移，z_0",
    ],
    [
        "1: slips from the first (Dahl); larger: bends elastically before it slips, n",
        "1: gleitet von Anfang an (Dahl); größer: biegt sich elastisch, bevor sie gleitet, n",
        "1 : glisse dès le début (Dahl) ; plus : fléchit élastiquement avant de glisser, n",
        "1：一开始就滑动（Dahl）；更大：先弹性变形再滑动，n",
    ],
    [
        "after a reversal a bent contact slips at once, or first springs back",
        "nach einer Umkehr gleitet ein gebogener Kontakt sofort oder federt zuerst zurück",
        "après une inversion un contact fléchi glisse aussitôt, ou revient d’abord élastiquement",
        "换向之后，变形的接触立即滑动，或先弹回",
    ],
    [
        "speed below which the contact creeps, v_c",
        "Geschwindigkeit, unter der der Kontakt kriecht, v_c",
        "vitesse au-dessous de laquelle le contact flue, v_c",
        "低于该速度时接触蠕动，v_c",
    ],
    [
        "slow (isothermal) stiffness at x = 0, k",
        "langsame (isotherme) Steifigkeit bei x = 0, k",
        "raideur lente (isotherme) en x = 0, k",
        "x = 0 处的慢速（等温）刚度，k",
    ],
    [
        "gas volume at x = 0 over the area of the rod, L: how soon it stiffens",
        "Gasvolumen bei x = 0 durch die Fläche der Stange, L: wie bald es steifer wird",
        "volume de gaz en x = 0 sur l’aire de la tige, L : à quelle allure il raidit",
        "x = 0 处气体体积与活塞杆面积之比，L：变硬的快慢",
    ],
    [
        "ratio of fast to slow stiffness, gamma",
        "Verhältnis von schneller zu langsamer Steifigkeit, gamma",
        "rapport de la raideur rapide à la lente, gamma",
        "快速与慢速刚度之比，gamma",
    ],
    [
        "time in which the gas takes the temperature of its wall, tau",
        "Zeit, in der das Gas die Temperatur seiner Wand annimmt, tau",
        "temps dans lequel le gaz prend la température de sa paroi, tau",
        "气体达到壁温所需的时间，tau",
    ],
    ["mass, M", "Masse, M", "masse, M", "质量，M"],
    [
        "time by which its force lags, tau; short beside the motion",
        "Zeit, um die ihre Kraft nacheilt, tau; kurz gegen die Bewegung",
        "temps dont son effort retarde, tau ; court devant le mouvement",
        "其力滞后的时间，tau；与运动相比很短",
    ],
    [
        "what moves it: the driven end, or the piston behind the series stiffness",
        "was sie bewegt: das angetriebene Ende oder der Kolben hinter der Reihensteifigkeit",
        "ce qui la meut : l’extrémité entraînée, ou le piston derrière la raideur en série",
        "由什么带动：驱动端，或串联刚度后的活塞",
    ],
    [
        "compression from x = 0 at which the stop is met, as a positive length",
        "Einfederung von x = 0 aus, bei der der Anschlag getroffen wird, als positive Länge",
        "compression depuis x = 0 à laquelle la butée est rencontrée, en longueur positive",
        "从 x = 0 起压缩到碰到限位的长度，取正值",
    ],
    ["stiffness at first contact", "Steifigkeit beim ersten Kontakt", "raideur au premier contact", "初始接触时的刚度"],
    [
        "depth at which the spring has twice the force of a straight one",
        "Tiefe, in der die Feder die doppelte Kraft einer geraden hat",
        "profondeur à laquelle le ressort a deux fois l’effort d’un ressort linéaire",
        "弹簧力达到线性弹簧两倍时的深度",
    ],
    [
        "share of the spring force that is lost on the way in and again on the way out",
        "Anteil der Federkraft, der auf dem Weg hinein und wieder hinaus verloren geht",
        "part de l’effort du ressort perdue à l’aller et de nouveau au retour",
        "压入和退出时各损失的弹簧力比例",
    ],
    [
        "hydraulic damping on the way in, at the depth of the progression",
        "hydraulische Dämpfung auf dem Weg hinein, in der Tiefe der Progression",
        "amortissement hydraulique à l’aller, à la profondeur de la progression",
        "压入时、渐进深度处的液压阻尼",
    ],
    [
        "hydraulic force with speed, or with its square (1 m/s alike)",
        "hydraulische Kraft mit der Geschwindigkeit oder ihrem Quadrat (bei 1 m/s gleich)",
        "effort hydraulique avec la vitesse, ou avec son carré (égaux à 1 m/s)",
        "液压力与速度成正比，或与其平方成正比（1 m/s 时相同）",
    ],
    [
        "extension from x = 0 at which the stop is met",
        "Ausfederung von x = 0 aus, bei der der Anschlag getroffen wird",
        "détente depuis x = 0 à laquelle la butée est rencontrée",
        "从 x = 0 起伸长到碰到限位的长度",
    ],
    [
        "method inside a step; automatic: the cheapest that keeps the error of a 1 ms step below a thousandth",
        "Verfahren innerhalb eines Schritts; automatic: das billigste, das den Fehler eines Schritts von 1 ms unter einem Tausendstel hält",
        "méthode dans un pas ; automatic : la moins coûteuse qui garde l’erreur d’un pas de 1 ms sous un millième",
        "步内方法；automatic：使 1 ms 步长误差低于千分之一的最省方法",
    ],
    [
        "substeps inside one host step; 0: as many as the model's stiffness and damping ask for",
        "Teilschritte innerhalb eines Schritts des Programms; 0: so viele, wie Steifigkeit und Dämpfung des Modells verlangen",
        "sous-pas dans un pas de l’hôte ; 0 : autant que la raideur et l’amortissement du modèle en demandent",
        "主机一步内的子步数；0：按模型刚度与阻尼所需",
    ],
];

#[cfg(test)]
mod tests {
    use super::*;
    use dashpot_core::parameter;
    use dashpot_core::parameter::GROUPS;
    use std::collections::BTreeSet;

    #[test]
    fn every_meaning_of_the_kernel_has_its_translations_and_none_is_left_over() {
        let of_kernel: BTreeSet<&str> = parameter::table()
            .map(|row| row.parameter.meaning)
            .chain(GROUPS.iter().map(|group| group.meaning))
            .collect();
        let known: BTreeSet<&str> = MEANINGS.iter().map(|meaning| meaning[0]).collect();
        assert_eq!(known.len(), MEANINGS.len(), "a meaning stands twice");
        assert_eq!(known, of_kernel);
    }

    #[test]
    fn translations_keep_symbols_and_are_no_copies() {
        assert_eq!(Language::ALL.map(|(code, _)| code), ["en", "de", "fr", "zh"]);
        // Symbols have an underscore, a power or a bar in them.
        let symbols = |text: &str| -> BTreeSet<String> {
            text.split([' ', ',', ';', ':', '，', '；', '：', '、', '（', '）', '(', ')'])
                .filter(|word| word.contains(['_', '^', '|']))
                .map(str::to_owned)
                .collect()
        };
        for meaning in MEANINGS {
            for other in &meaning[1..] {
                assert!(!other.trim().is_empty(), "{}", meaning[0]);
                assert_eq!(symbols(other), symbols(meaning[0]), "{other}");
                let is_sentence = meaning[0].split(' ').count() > 3;
                assert!(!is_sentence || *other != meaning[0], "{}", meaning[0]);
            }
        }
    }

    #[test]
    fn a_meaning_is_said_in_the_language_of_the_words() {
        let said = |language: Language| language.words().meaning("constant gas force");
        assert_eq!(
            Language::ALL.map(|(_, l)| said(l)),
            ["constant gas force", "konstante Gaskraft", "effort du gaz constant", "恒定气体力"]
        );
    }
}
