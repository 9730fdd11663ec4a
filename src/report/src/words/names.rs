//! What effects, elements and parameters are called in words. Their identifiers stand in model files, in `--help` and in what scripts read;
//! a sentence for people names them in words, with the identifier in brackets where it comes first.

use super::{Language, Words};
use std::collections::HashMap;
use std::sync::LazyLock;

/// One name: identifier, English, German, French, Chinese. Short, and without commas, since names stand in lists.
type Named = [&'static str; 5];

static BY_IDENTIFIER: LazyLock<HashMap<&'static str, &'static Named>> =
    LazyLock::new(|| NAMES.iter().map(|named| (named[0], named)).collect());

/// Places of sentences where an identifier is no effect and no parameter.
///
/// Tests and files may be called like one, and what a command takes is listed as it is written.
const OTHER: &[&str] =
    &["at", "column", "file", "folder", "found", "known", "option", "record", "test", "tests", "text", "twin", "unit"];

impl Words {
    /// The short name of an effect, an element or a parameter; `None` for anything else.
    pub fn name_of(&self, identifier: &str) -> Option<&'static str> {
        let language = Language::ALL.iter().position(|(code, _)| *code == self.code)?;
        BY_IDENTIFIER.get(identifier).map(|named| named[language + 1])
    }

    /// The name with its identifier in brackets, for headings and tables.
    pub fn named(&self, identifier: &str) -> String {
        match self.name_of(identifier) {
            Some(name) => self.bracketed(name, identifier),
            None => identifier.to_owned(),
        }
    }

    fn bracketed(&self, name: &str, identifier: &str) -> String {
        if self.code == "zh" { format!("{name}（{identifier}）") } else { format!("{name} ({identifier})") }
    }

    /// Whether what stands at a place of a sentence is an effect, an element or a parameter.
    pub(super) fn is_named(&self, place: &str, text: &str) -> bool {
        !OTHER.contains(&place) && BY_IDENTIFIER.contains_key(text)
    }

    /// A sentence in which identifiers stand between [`MARK`]s: each is put in words, at its first place with itself in brackets. Brackets that
    /// follow are drawn into those: "gas force (gas_force, 97 % sure)".
    pub(super) fn with_names(&self, marked: &str) -> String {
        let mut pieces = marked.split(MARK);
        let mut text = pieces.next().unwrap_or("").to_owned();
        let mut told: Vec<&str> = Vec::new();
        while let (Some(identifier), Some(behind)) = (pieces.next(), pieces.next()) {
            let first = !told.contains(&identifier);
            told.push(identifier);
            match self.name_of(identifier).filter(|_| !first) {
                Some(name) => text += &(name.to_owned() + behind),
                None => {
                    let named = self.named(identifier);
                    let [open, close, comma] =
                        if self.code == "zh" { ["（", "）", "，"] } else { [" (", ")", ", "] };
                    match (behind.strip_prefix(open), named.strip_suffix(close)) {
                        (Some(inside), Some(name)) => text += &format!("{name}{comma}{inside}"),
                        _ => text += &(named + behind),
                    }
                }
            }
        }
        text
    }
}

/// Stands before and behind an identifier until the sentence is whole; no text has it.
pub(super) const MARK: char = '\u{1}';

const NAMES: &[Named] = &[
    // Effects and elements.
    ["fv_curve", "FV curve", "FV-Kurve", "courbe FV", "FV 曲线"],
    ["gas_preload", "constant gas force", "konstante Gaskraft", "effort de gaz constant", "恒定气体力"],
    ["gas_spring", "gas spring", "Gasfeder", "ressort à gaz", "气体弹簧"],
    ["coulomb_friction", "dry friction", "Trockenreibung", "frottement sec", "干摩擦"],
    [
        "stribeck_friction",
        "friction with break-away",
        "Reibung mit Losbrechkraft",
        "frottement avec décollement",
        "带起动峰值的摩擦",
    ],
    [
        "presliding_friction",
        "presliding friction",
        "Reibung mit Vorgleiten",
        "frottement à préglissement",
        "预滑移摩擦",
    ],
    ["viscous_friction", "viscous friction", "viskose Reibung", "frottement visqueux", "黏性摩擦"],
    [
        "side_force_friction",
        "friction by side force",
        "Reibung durch Seitenkraft",
        "frottement dû à l’effort latéral",
        "侧向力引起的摩擦",
    ],
    ["series_compliance", "series compliance", "Reihennachgiebigkeit", "souplesse en série", "串联柔度"],
    ["bushing", "rubber bush", "Gummilager", "articulation élastique", "橡胶衬套"],
    ["parallel_spring", "parallel spring", "Parallelfeder", "ressort parallèle", "并联弹簧"],
    ["oil_compressibility", "compressible oil", "Nachgiebigkeit des Öls", "compressibilité de l’huile", "油液可压缩性"],
    ["aeration", "air in the oil", "Luft im Öl", "air dans l’huile", "油中含气"],
    ["cavitation", "cavitation", "Kavitation", "cavitation", "空化"],
    [
        "gas_warming",
        "gas force over temperature",
        "Gaskraft über der Temperatur",
        "effort du gaz selon la température",
        "气体力随温度的变化",
    ],
    [
        "temperature_fade",
        "fading with temperature",
        "Nachlassen mit der Temperatur",
        "baisse avec la température",
        "温升衰减",
    ],
    [
        "position_dependent_damping",
        "damping that depends on the position",
        "hubabhängige Dämpfung",
        "amortissement dépendant de la position",
        "位置相关阻尼",
    ],
    ["bump_stop", "bump stop", "Druckanschlag", "butée de compression", "压缩限位"],
    ["rebound_stop", "rebound stop", "Zuganschlag", "butée de détente", "复原限位"],
    ["free_play", "free play", "Spiel", "jeu", "间隙"],
    [
        "frequency_selective_damping",
        "frequency-selective damping",
        "frequenzselektive Dämpfung",
        "amortissement sélectif en fréquence",
        "频率选择阻尼",
    ],
    ["valve_hysteresis", "valve hysteresis", "Ventilhysterese", "hystérésis de clapet", "阀滞后"],
    ["moving_mass", "moving mass", "bewegte Masse", "masse mobile", "运动质量"],
    ["lagged_polynomial", "polynomial with lag", "Polynom mit Verzögerung", "polynôme avec retard", "带滞后的多项式"],
    ["integration", "integration", "Integration", "intégration", "积分设置"],
    ["cylinder_expansion", "widening of the cylinder", "Zylinderaufweitung", "dilatation du cylindre", "缸筒膨胀"],
    // Effects of the rig, and what looks like something that has no name.
    [
        "channel_delay",
        "delay of the force channel",
        "Verzug des Kraftkanals",
        "retard de la voie d’effort",
        "力通道延迟",
    ],
    [
        "force_offset",
        "zero error of the load cell",
        "Nullpunktfehler der Kraftmessdose",
        "erreur de zéro du capteur d’effort",
        "力传感器零点误差",
    ],
    [
        "force_drift",
        "zero drift of the load cell",
        "Nullpunktdrift der Kraftmessdose",
        "dérive du zéro du capteur d’effort",
        "力传感器零点漂移",
    ],
    [
        "gain_drift",
        "gain drift of the force channel",
        "Verstärkungsdrift des Kraftkanals",
        "dérive du gain de la voie d’effort",
        "力通道增益漂移",
    ],
    [
        "load_dependent_friction",
        "friction that grows with the load",
        "lastabhängige Reibung",
        "frottement croissant avec la charge",
        "随载荷增大的摩擦",
    ],
    [
        "load_cell_hysteresis",
        "hysteresis of the load cell",
        "Hysterese der Kraftmessdose",
        "hystérésis du capteur d’effort",
        "力传感器滞后",
    ],
    ["resonance", "resonance", "Resonanz", "résonance", "共振"],
    // Their numbers.
    ["delay", "delay", "Verzug", "retard", "延迟"],
    [
        "rig_mass",
        "mass on the load cell",
        "Masse an der Kraftmessdose",
        "masse sur le capteur d’effort",
        "力传感器上的质量",
    ],
    ["offset", "zero error", "Nullpunktfehler", "erreur de zéro", "零点误差"],
    ["drift", "drift", "Drift", "dérive", "漂移"],
    ["whole_drift", "drift in all", "Drift insgesamt", "dérive totale", "总漂移"],
    ["share", "share", "Anteil", "part", "比例"],
    ["share_across", "share across", "Anteil in Querphase", "part en quadrature", "正交比例"],
    ["share_growth", "growth of the share", "Zunahme des Anteils", "croissance de la part", "比例的增长"],
    ["cooling_rate", "cooling rate", "Abkühlrate", "vitesse de refroidissement", "冷却速率"],
    // Parts of the FV curve that change as one.
    ["rebound_curve", "rebound force", "Kraft der Zugstufe", "effort en détente", "复原力"],
    ["compression_curve", "compression force", "Kraft der Druckstufe", "effort en compression", "压缩力"],
    [
        "rebound_low_speed",
        "rebound force at low speed",
        "Zugstufe bei kleiner Geschwindigkeit",
        "effort en détente à basse vitesse",
        "低速复原力",
    ],
    [
        "compression_low_speed",
        "compression force at low speed",
        "Druckstufe bei kleiner Geschwindigkeit",
        "effort en compression à basse vitesse",
        "低速压缩力",
    ],
    [
        "rebound_high_speed",
        "rebound force at high speed",
        "Zugstufe bei hoher Geschwindigkeit",
        "effort en détente à haute vitesse",
        "高速复原力",
    ],
    [
        "compression_high_speed",
        "compression force at high speed",
        "Druckstufe bei hoher Geschwindigkeit",
        "effort en compression à haute vitesse",
        "高速压缩力",
    ],
    // The FV curve.
    ["fv_form", "form of the FV curve", "Form der FV-Kurve", "forme de la courbe FV", "FV 曲线的形式"],
    [
        "fv_interpolation",
        "interpolation of the FV curve",
        "Interpolation der FV-Kurve",
        "interpolation de la courbe FV",
        "FV 曲线的插值",
    ],
    [
        "fv_velocity",
        "velocity of the FV curve",
        "Geschwindigkeit der FV-Kurve",
        "vitesse de la courbe FV",
        "FV 曲线的速度",
    ],
    ["fv_force", "force of the FV curve", "Kraft der FV-Kurve", "effort de la courbe FV", "FV 曲线的力"],
    [
        "fv_rebound_c1",
        "first rebound slope",
        "erste Steigung der Zugstufe",
        "première pente en détente",
        "复原第一斜率",
    ],
    [
        "fv_rebound_c2",
        "second rebound slope",
        "zweite Steigung der Zugstufe",
        "deuxième pente en détente",
        "复原第二斜率",
    ],
    [
        "fv_rebound_c3",
        "third rebound slope",
        "dritte Steigung der Zugstufe",
        "troisième pente en détente",
        "复原第三斜率",
    ],
    ["fv_rebound_v1", "first rebound knee", "erster Knick der Zugstufe", "premier coude en détente", "复原第一拐点"],
    ["fv_rebound_v2", "second rebound knee", "zweiter Knick der Zugstufe", "second coude en détente", "复原第二拐点"],
    [
        "fv_compression_c1",
        "first compression slope",
        "erste Steigung der Druckstufe",
        "première pente en compression",
        "压缩第一斜率",
    ],
    [
        "fv_compression_c2",
        "second compression slope",
        "zweite Steigung der Druckstufe",
        "deuxième pente en compression",
        "压缩第二斜率",
    ],
    ["fv_compression_v1", "compression knee", "Knick der Druckstufe", "coude en compression", "压缩拐点"],
    // In series.
    ["series_stiffness", "series stiffness", "Reihensteifigkeit", "raideur en série", "串联刚度"],
    ["series_damping", "series damping", "Reihendämpfung", "amortissement en série", "串联阻尼"],
    ["internal_mass", "internal mass", "innere Masse", "masse interne", "内部质量"],
    [
        "series_load",
        "load of the series spring",
        "Last der Reihenfeder",
        "charge du ressort en série",
        "串联弹簧的载荷",
    ],
    ["free_play_gap", "size of the play", "Größe des Spiels", "grandeur du jeu", "间隙大小"],
    ["free_play_load", "load on the play", "Last auf dem Spiel", "charge sur le jeu", "间隙处的载荷"],
    ["free_play_force", "softness of the contact", "Weichheit der Anlage", "souplesse du contact", "接触柔软度"],
    ["bushing_hardening", "hardening of the rubber", "Verhärtung des Gummis", "durcissement du caoutchouc", "橡胶硬化"],
    [
        "bushing_loss_stiffness",
        "dynamic stiffening of the rubber",
        "dynamische Versteifung des Gummis",
        "raidissement dynamique du caoutchouc",
        "橡胶动态增刚",
    ],
    [
        "bushing_loss_time",
        "relaxation time of the rubber",
        "Relaxationszeit des Gummis",
        "temps de relaxation du caoutchouc",
        "橡胶松弛时间",
    ],
    [
        "bushing_slip",
        "slip travel of the rubber",
        "Gleitweg des Gummis",
        "course de glissement du caoutchouc",
        "橡胶滑移量",
    ],
    [
        "bushing_stop",
        "travel of the rubber to its stop",
        "Gummiweg bis zum Anschlag",
        "course du caoutchouc à la butée",
        "橡胶到限位的行程",
    ],
    [
        "bushing_stop_stiffness",
        "stiffness of the rubber’s stop",
        "Steifigkeit des Gummianschlags",
        "raideur de la butée du caoutchouc",
        "橡胶限位刚度",
    ],
    [
        "bushing_slow_stiffness",
        "slow stiffening of the rubber",
        "langsame Versteifung des Gummis",
        "raidissement lent du caoutchouc",
        "橡胶慢速增刚",
    ],
    [
        "bushing_slow_time",
        "slow relaxation time of the rubber",
        "langsame Relaxationszeit des Gummis",
        "temps de relaxation lente du caoutchouc",
        "橡胶慢速松弛时间",
    ],
    // Oil.
    [
        "oil_stiffness",
        "stiffness of the oil column",
        "Steifigkeit der Ölsäule",
        "raideur de la colonne d’huile",
        "油柱刚度",
    ],
    [
        "oil_shortening",
        "shortening of the oil column",
        "Verkürzung der Ölsäule",
        "raccourcissement de la colonne d’huile",
        "油柱缩短率",
    ],
    ["oil_chambers", "chambers that yield", "nachgiebige Kammern", "chambres souples", "受压变形的腔"],
    [
        "oil_compression",
        "oil stiffness ratio of compression",
        "Verhältnis der Ölsteifigkeiten",
        "rapport des raideurs de l’huile",
        "压缩与复原油柱刚度比",
    ],
    ["aeration_stroke", "stroke taken up by air", "Luftweg", "course absorbée par l’air", "空气吸收的行程"],
    [
        "aeration_force",
        "force that closes the air",
        "Kraft zum Schließen der Luft",
        "effort qui absorbe l’air",
        "压缩空气所需的力",
    ],
    [
        "aeration_compression",
        "air ratio of compression",
        "Luftverhältnis der Druckstufe",
        "rapport d’air en compression",
        "压缩侧空气行程比",
    ],
    ["cavitation_force", "cavitation limit", "Kavitationsgrenze", "limite de cavitation", "空化限力"],
    ["cavitation_side", "stroke that cavitates", "kavitierende Richtung", "course qui cavite", "发生空化的行程"],
    ["cavitation_return", "force on the return", "Kraft auf dem Rückweg", "effort au retour", "返程保留的力"],
    ["cavitation_form", "form of the cavitation", "Form der Kavitation", "forme de la cavitation", "空化的形式"],
    [
        "cavitation_velocity",
        "speed limit of the foot valve",
        "Grenzgeschwindigkeit des Bodenventils",
        "vitesse limite du clapet de pied",
        "底阀极限速度",
    ],
    ["cavitation_unfilled", "share not refilled", "nicht nachgefüllter Anteil", "part non remplie", "未补充的比例"],
    ["lost_stroke", "lost stroke", "Totgang", "course perdue", "空行程"],
    ["cavitation_onset", "onset of the cavitation", "Beginn der Kavitation", "début de la cavitation", "空化起点"],
    ["cavitation_expansion", "expansion of the void", "Aufweitung des Hohlraums", "expansion du vide", "空穴膨胀"],
    // Over the stroke.
    [
        "bypass_share",
        "missing share in the zone",
        "fehlender Anteil in der Zone",
        "part manquante dans la zone",
        "区域内缺失的比例",
    ],
    ["bypass_centre", "middle of the zone", "Mitte der Zone", "milieu de la zone", "区域中点"],
    ["bypass_half_width", "half-width of the zone", "halbe Breite der Zone", "demi-largeur de la zone", "区域半宽"],
    ["bypass_blend", "transition of the zone", "Übergang der Zone", "transition de la zone", "区域过渡长度"],
    ["bypass_strokes", "strokes of the zone", "Richtungen der Zone", "courses de la zone", "区域起作用的行程"],
    ["bypass_form", "form of the zone", "Form der Zone", "forme de la zone", "区域的形式"],
    ["bypass_flow", "flow through the groove", "Strom durch die Nut", "débit de la rainure", "沟槽流量"],
    // Heat.
    ["fade_source", "source of the temperature", "Herkunft der Temperatur", "origine de la température", "温度来源"],
    ["fade_coefficient", "fall per kelvin", "Abfall je Kelvin", "baisse par kelvin", "每开尔文的下降"],
    ["fade_reference", "reference temperature", "Bezugstemperatur", "température de référence", "参考温度"],
    ["heat_capacity", "heat capacity", "Wärmekapazität", "capacité thermique", "热容"],
    ["heat_transfer", "heat given off per kelvin", "Wärmeabgabe je Kelvin", "chaleur cédée par kelvin", "每开尔文散热"],
    [
        "fade_laminar_force",
        "laminar force limit",
        "Grenzkraft laminarer Strömung",
        "effort limite laminaire",
        "层流限力",
    ],
    ["fade_slackening", "slackening of the fall", "Abflachen des Abfalls", "atténuation de la baisse", "下降趋缓系数"],
    // Valves.
    [
        "fsd_form",
        "form of the frequency dependence",
        "Form der Frequenzabhängigkeit",
        "forme de la dépendance en fréquence",
        "频率相关的形式",
    ],
    [
        "fsd_share",
        "share lost by fast strokes",
        "Verlust bei schnellen Hüben",
        "perte en courses rapides",
        "快速行程损失比例",
    ],
    [
        "fsd_time",
        "time between fast and slow",
        "Zeitkonstante der Frequenzabhängigkeit",
        "constante de temps en fréquence",
        "快慢分界时间",
    ],
    [
        "fsd_velocity",
        "filling speed of the chamber",
        "Füllgeschwindigkeit der Steuerkammer",
        "vitesse de remplissage",
        "控制腔充满速度",
    ],
    ["fsd_flow", "bypass flow", "Bypass-Strom", "débit de dérivation", "旁通流量"],
    [
        "fsd_force",
        "filling force of the chamber",
        "Füllkraft der Steuerkammer",
        "effort de remplissage",
        "控制腔充液力",
    ],
    [
        "fsd_laminar_force",
        "laminar limit of the bypass",
        "Laminargrenze des Bypasses",
        "limite laminaire de la dérivation",
        "旁通层流限力",
    ],
    [
        "valve_hysteresis_share",
        "share of the valve hysteresis",
        "Anteil der Ventilhysterese",
        "part de l’hystérésis de clapet",
        "阀滞后比例",
    ],
    [
        "valve_opening_force",
        "opening force of the valve",
        "Öffnungskraft des Ventils",
        "effort d’ouverture du clapet",
        "阀开启力",
    ],
    [
        "valve_closing_ratio",
        "closing to opening force",
        "Verhältnis Schließ- zu Öffnungskraft",
        "rapport fermeture/ouverture",
        "关闭与开启力之比",
    ],
    ["valve_time", "time of the valve", "Stellzeit des Ventils", "temps du clapet", "阀动作时间"],
    [
        "valve_width",
        "opening range of the valve",
        "Öffnungsbereich des Ventils",
        "plage d’ouverture du clapet",
        "阀开启范围",
    ],
    [
        "valve_form",
        "form of the valve hysteresis",
        "Form der Ventilhysterese",
        "forme de l’hystérésis de clapet",
        "阀滞后的形式",
    ],
    ["valve_play", "play of the valve", "Spiel des Ventils", "jeu du clapet", "阀间隙"],
    [
        "valve_damping",
        "damping ratio of the valve",
        "Dämpfungsmaß des Ventils",
        "taux d’amortissement du clapet",
        "阀阻尼比",
    ],
    // Springs.
    ["spring_linear", "linear spring rate", "lineare Federrate", "raideur linéaire", "线性刚度"],
    ["spring_quadratic", "quadratic spring rate", "quadratische Federrate", "raideur quadratique", "二次刚度"],
    ["spring_cubic", "cubic spring rate", "kubische Federrate", "raideur cubique", "三次刚度"],
    ["spring_quartic", "quartic spring rate", "Federrate vierten Grades", "raideur du quatrième degré", "四次刚度"],
    [
        "spring_displacement",
        "displacement of the spring table",
        "Weg der Federtabelle",
        "déplacement de la table du ressort",
        "弹簧表的位移",
    ],
    [
        "spring_force",
        "force of the spring table",
        "Kraft der Federtabelle",
        "effort de la table du ressort",
        "弹簧表的力",
    ],
    // Friction.
    ["coulomb_force", "friction force", "Reibkraft", "effort de frottement", "摩擦力"],
    [
        "coulomb_steepness",
        "steepness of the friction",
        "Steilheit der Reibung",
        "raideur du frottement",
        "摩擦换向陡度",
    ],
    ["stribeck_form", "Stribeck form", "Stribeck-Form", "forme de Stribeck", "Stribeck 形式"],
    ["stribeck_breakaway_force", "break-away force", "Losbrechkraft", "effort de décollement", "起动力"],
    [
        "stribeck_coulomb_force",
        "friction after break-away",
        "Reibkraft nach dem Losbrechen",
        "frottement après décollement",
        "起动后的摩擦力",
    ],
    [
        "stribeck_breakaway_velocity",
        "break-away velocity",
        "Losbrechgeschwindigkeit",
        "vitesse de décollement",
        "起动速度",
    ],
    ["stribeck_velocity", "Stribeck velocity", "Stribeck-Geschwindigkeit", "vitesse de Stribeck", "Stribeck 速度"],
    ["stribeck_fall", "exponent of the fall", "Exponent des Abfalls", "exposant de la chute", "下降指数"],
    ["stribeck_rise", "height of the peak", "Höhe der Spitze", "hauteur de la pointe", "峰值高度"],
    ["stribeck_rise_power", "exponent of the rise", "Exponent des Anstiegs", "exposant de la montée", "上升指数"],
    ["viscous_coefficient", "viscous coefficient", "viskoser Beiwert", "coefficient visqueux", "黏性系数"],
    [
        "side_force_coefficient",
        "friction per side force",
        "Reibung je Seitenkraft",
        "frottement par effort latéral",
        "单位侧向力的摩擦",
    ],
    [
        "side_force_steepness",
        "steepness of the side-force friction",
        "Steilheit der Seitenkraftreibung",
        "raideur du frottement latéral",
        "侧向力摩擦陡度",
    ],
    [
        "presliding_force",
        "presliding friction force",
        "Reibkraft bei Vorgleiten",
        "effort de frottement à préglissement",
        "预滑移摩擦力",
    ],
    ["presliding_length", "presliding travel", "Vorgleitweg", "course de préglissement", "预滑移位移"],
    ["presliding_power", "shape of the presliding", "Form des Vorgleitens", "forme du préglissement", "预滑移形状"],
    [
        "presliding_return",
        "return after a reversal",
        "Rückgang nach der Umkehr",
        "retour après inversion",
        "换向后的回弹",
    ],
    ["presliding_creep", "creep velocity", "Kriechgeschwindigkeit", "vitesse de fluage", "蠕动速度"],
    // Gas.
    ["gas_force", "gas force", "Gaskraft", "effort de gaz", "气体力"],
    [
        "gas_warming_rate",
        "growth of the gas force per kelvin",
        "Zuwachs der Gaskraft je Kelvin",
        "hausse de l’effort de gaz par kelvin",
        "每开尔文的气体力增量",
    ],
    [
        "gas_warming_reference",
        "reference temperature of the gas force",
        "Bezugstemperatur der Gaskraft",
        "température de référence du gaz",
        "气体力参考温度",
    ],
    ["gas_stiffness", "gas stiffness", "Gassteifigkeit", "raideur du gaz", "气体刚度"],
    ["gas_length", "length of the gas column", "Länge der Gassäule", "longueur de la colonne de gaz", "气柱长度"],
    ["gas_adiabatic_index", "adiabatic index", "Adiabatenexponent", "exposant adiabatique", "绝热指数"],
    ["gas_thermal_time", "thermal time of the gas", "Wärmezeit des Gases", "temps thermique du gaz", "气体热时间"],
    // The model of the literature.
    [
        "polynomial",
        "coefficients of the polynomial",
        "Koeffizienten des Polynoms",
        "coefficients du polynôme",
        "多项式系数",
    ],
    ["lag_slow", "lag at low speed", "Verzögerung bei kleiner Geschwindigkeit", "retard à basse vitesse", "低速滞后"],
    ["lag_fast", "lag at high speed", "Verzögerung bei großer Geschwindigkeit", "retard à haute vitesse", "高速滞后"],
    [
        "lag_v1",
        "lower speed of the lag",
        "untere Geschwindigkeit der Verzögerung",
        "vitesse basse du retard",
        "滞后的低速界",
    ],
    [
        "lag_v2",
        "upper speed of the lag",
        "obere Geschwindigkeit der Verzögerung",
        "vitesse haute du retard",
        "滞后的高速界",
    ],
    // Masses and stops.
    [
        "moving_mass_time",
        "lag of the moving mass",
        "Nacheilen der bewegten Masse",
        "retard de la masse mobile",
        "运动质量的滞后",
    ],
    [
        "moving_mass_place",
        "place of the moving mass",
        "Ort der bewegten Masse",
        "place de la masse mobile",
        "运动质量的位置",
    ],
    [
        "bump_stop_clearance",
        "travel to the bump stop",
        "Weg bis zum Druckanschlag",
        "course jusqu’à la butée de compression",
        "到压缩限位的行程",
    ],
    [
        "bump_stop_stiffness",
        "stiffness of the bump stop",
        "Steifigkeit des Druckanschlags",
        "raideur de la butée de compression",
        "压缩限位刚度",
    ],
    [
        "bump_stop_progression",
        "progression of the bump stop",
        "Progression des Druckanschlags",
        "progressivité de la butée de compression",
        "压缩限位渐进深度",
    ],
    [
        "bump_stop_loss",
        "loss of the bump stop",
        "Verlust des Druckanschlags",
        "perte de la butée de compression",
        "压缩限位损失",
    ],
    [
        "bump_stop_damping",
        "damping of the bump stop",
        "Dämpfung des Druckanschlags",
        "amortissement de la butée de compression",
        "压缩限位阻尼",
    ],
    [
        "bump_stop_flow",
        "flow of the bump stop",
        "Strömung des Druckanschlags",
        "écoulement de la butée de compression",
        "压缩限位流动形式",
    ],
    [
        "rebound_stop_clearance",
        "travel to the rebound stop",
        "Weg bis zum Zuganschlag",
        "course jusqu’à la butée de détente",
        "到复原限位的行程",
    ],
    [
        "rebound_stop_stiffness",
        "stiffness of the rebound stop",
        "Steifigkeit des Zuganschlags",
        "raideur de la butée de détente",
        "复原限位刚度",
    ],
    [
        "rebound_stop_progression",
        "progression of the rebound stop",
        "Progression des Zuganschlags",
        "progressivité de la butée de détente",
        "复原限位渐进深度",
    ],
    [
        "rebound_stop_loss",
        "loss of the rebound stop",
        "Verlust des Zuganschlags",
        "perte de la butée de détente",
        "复原限位损失",
    ],
    [
        "rebound_stop_damping",
        "damping of the rebound stop",
        "Dämpfung des Zuganschlags",
        "amortissement de la butée de détente",
        "复原限位阻尼",
    ],
    [
        "rebound_stop_flow",
        "flow of the rebound stop",
        "Strömung des Zuganschlags",
        "écoulement de la butée de détente",
        "复原限位流动形式",
    ],
    // The step.
    ["method", "method of integration", "Integrationsverfahren", "méthode d’intégration", "积分方法"],
    ["substeps", "substeps", "Teilschritte", "sous-pas", "子步数"],
];

#[cfg(test)]
mod tests {
    use super::super::{DE, EN, FR, TERMINAL, ZH};
    use super::*;
    use dashpot_core::parameter;
    use dashpot_core::parameter::GROUPS;
    use dashpot_diagnosis::EFFECTS;
    use std::collections::BTreeSet;

    #[test]
    fn every_effect_element_and_parameter_has_a_short_name_in_every_language() {
        let parameters = parameter::table().map(|row| row.parameter.name);
        let all: Vec<&str> =
            EFFECTS.iter().copied().chain(GROUPS.iter().map(|group| group.name)).chain(parameters).collect();
        for identifier in all {
            for words in [&EN, &DE, &FR, &ZH] {
                assert!(words.name_of(identifier).is_some(), "{identifier} has no name in {}", words.code);
            }
        }
    }

    #[test]
    fn names_are_short_and_each_stands_once() {
        let known: BTreeSet<&str> = NAMES.iter().map(|named| named[0]).collect();
        assert_eq!(known.len(), NAMES.len(), "a name stands twice");
        for named in NAMES {
            for name in &named[1..] {
                assert!(!name.trim().is_empty() && name.chars().count() <= 42 && !name.contains([',', '_']), "{name}");
            }
        }
    }

    #[test]
    fn an_identifier_stands_in_brackets_where_it_comes_first() {
        let sentence = "\u{1}gas_force\u{1} 1 N, \u{1}gas_force\u{1} 2 N, \u{1}aeration\u{1} (97 %)";
        assert_eq!(DE.with_names(sentence), "Gaskraft (gas_force) 1 N, Gaskraft 2 N, Luft im Öl (aeration, 97 %)");
        assert_eq!(ZH.with_names("缺少：\u{1}aeration\u{1}（把握 97 %）"), "缺少：油中含气（aeration，把握 97 %）");
        assert_eq!(EN.named("rubber"), "rubber");
        // The terminal keeps what scripts read.
        assert_eq!(TERMINAL.with_names("missing: \u{1}aeration\u{1} (97 % sure)"), "missing: aeration (97 % sure)");
        assert!(!EN.is_named("test", "aeration") && EN.is_named("names", "aeration"));
    }
}
