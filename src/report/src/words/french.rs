//! Articles before French names of effects. Texts of the French file contain a marker, because the article follows from gender and first letter
//! of the name.

/// Marker of a definite article: le, la or l’.
const THE: &str = "‹le›";
/// Marker of the preposition de with a definite article: du, de la or de l’.
const OF_THE: &str = "‹de›";

/// Feminine nouns with which names of effects begin.
const FEMININE: &[&str] = &[
    "articulation",
    "baisse",
    "butée",
    "cavitation",
    "compressibilité",
    "courbe",
    "dilatation",
    "dérive",
    "erreur",
    "hystérésis",
    "intégration",
    "masse",
    "résonance",
    "souplesse",
];

fn is_feminine(name: &str) -> bool {
    FEMININE.contains(&first_noun(name))
}

fn first_noun(name: &str) -> &str {
    name.split(' ').next().unwrap_or(name)
}

/// Returns the definite article of a name, with a space after le and la. Every `h` at the beginning of these names is mute.
fn article(name: &str) -> &'static str {
    match name.chars().next() {
        Some('a' | 'e' | 'é' | 'h' | 'i' | 'o' | 'u') => "l’",
        _ if is_feminine(name) => "la ",
        _ => "le ",
    }
}

/// Replaces a marker at the end of `text` by the article for the name that follows.
pub(super) fn add_article(text: &mut String, name: &str) {
    let article = article(name);
    let of_the = if article == "le " { "du ".to_owned() } else { format!("de {article}") };
    for (marker, words) in [(THE, article), (OF_THE, &of_the)] {
        if text.ends_with(marker) {
            text.truncate(text.len() - marker.len());
            text.push_str(words);
        }
    }
}

/// Removes markers that no name follows, such as one before an identifier without a name.
pub(super) fn without_markers(text: String) -> String {
    if text.contains('‹') { text.replace(THE, "").replace(OF_THE, "de ") } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{DE, FR};
    use dashpot_core::parameter::Element;
    use dashpot_messages::Sentence;

    /// Masculine nouns with which names of effects begin.
    const MASCULINE: &[&str] = &[
        "air",
        "amortissement",
        "clapet",
        "effort",
        "frottement",
        "glissement",
        "jeu",
        "polynôme",
        "ressort",
        "retard",
    ];

    #[test]
    fn the_gender_of_every_element_and_effect_is_known() {
        let of_the_rig = [
            "channel_delay",
            "force_offset",
            "force_drift",
            "gain_drift",
            "load_dependent_friction",
            "load_cell_hysteresis",
        ];
        let effects = of_the_rig.into_iter().chain(["resonance", "moving_mass"]);
        for identifier in Element::all().map(Element::name).chain(effects) {
            let name = FR.name_of(identifier).unwrap_or_else(|| panic!("{identifier} has no name in fr.ftl"));
            assert!(is_feminine(name) != MASCULINE.contains(&first_noun(name)), "{identifier}: {name}");
        }
    }

    #[test]
    fn effects_of_a_french_verdict_have_articles() {
        let effects = |name: &'static str, old: &'static str| {
            let template = |id: &str| {
                let mut all = dashpot_diagnosis::templates().to_vec().into_iter();
                all.find(|template| template.id() == id).unwrap()
            };
            let instead = Sentence::from(template("diagnosis-instead-of")).with("effect", old);
            Sentence::from(template("diagnosis-name-and-sure"))
                .with("effect", name)
                .with("percent", "95 %")
                .with_sentence("instead", instead)
        };
        let french = |name, old| FR.say(&effects(name, old));
        assert_eq!(
            french("series_compliance", "oil_compressibility"),
            "la souplesse en série (series_compliance, sûr à 95 %, à la place de la compressibilité de l’huile (oil_compressibility))"
        );
        assert_eq!(
            french("aeration", "coulomb_friction"),
            "l’air dans l’huile (aeration, sûr à 95 %, à la place du frottement sec (coulomb_friction))"
        );
        assert!(french("valve_hysteresis", "aeration").contains("à la place de l’air dans l’huile"));
        // An identifier without a name has no article.
        assert_eq!(french("no_effect", "none_such"), "no_effect (sûr à 95 %, à la place de none_such)");
        assert!(DE.say(&effects("aeration", "coulomb_friction")).starts_with("Luft im Öl (aeration"));
    }
}
