//! Words of the choices that a model makes: forms and variants of its elements.
//!
//! Model files and scripts use the identifiers; a list for people has them in words.

use super::{Language, Words};
use std::borrow::Cow;

/// One choice: identifier, English, German, French, Chinese.
type Choice = [&'static str; 5];

impl Words {
    /// A word that a parameter may be set to, in this language.
    pub fn choice<'a>(&self, identifier: &'a str) -> Cow<'a, str> {
        let language = Language::ALL.iter().position(|(code, _)| *code == self.code);
        let known = CHOICES.iter().find(|choice| choice[0] == identifier);
        match (language, known) {
            (Some(language), Some(choice)) => Cow::Borrowed(choice[language + 1]),
            _ => Cow::Owned(identifier.replace('_', " ")),
        }
    }
}

#[rustfmt::skip]
const CHOICES: &[Choice] = &[
    ["automatic", "automatic", "automatisch", "automatique", "自动"],
    ["both", "both", "beide", "les deux", "两者"],
    ["bypass", "bypass", "Umgehung", "dérivation", "旁通"],
    ["cap", "limited force", "begrenzte Kraft", "effort limité", "力限幅"],
    ["compression", "compression", "Druckstufe", "compression", "压缩"],
    ["cubic_each_side", "cubic each side", "kubisch je Seite", "cubique par côté", "分侧三次"],
    ["driven end", "driven end", "bewegtes Ende", "extrémité menée", "驱动端"],
    ["elastic", "elastic return", "elastisch zurück", "retour élastique", "弹性回复"],
    ["euler", "Euler", "Euler", "Euler", "欧拉法"],
    ["factor", "factor", "Faktor", "facteur", "系数"],
    ["filter", "filter", "Filter", "filtre", "滤波"],
    ["foot_valve", "foot valve", "Bodenventil", "clapet de pied", "底阀"],
    ["fourth_order", "fourth order", "vierte Ordnung", "quatrième ordre", "四阶"],
    ["full", "full", "vollständig", "complète", "完整"],
    ["gap", "gap", "Spalt", "jeu", "间隙"],
    ["groove", "groove", "Nut", "rainure", "沟槽"],
    ["hydraulic", "hydraulic force", "hydraulische Kraft", "effort hydraulique", "液压力"],
    ["inside", "inside", "innen", "à l’intérieur", "内部"],
    ["linear", "linear", "linear", "linéaire", "线性"],
    ["measured", "measured", "gemessen", "mesurée", "实测"],
    ["monotone_cubic", "monotone cubic", "monoton kubisch", "cubique monotone", "单调三次"],
    ["opening", "opening", "Öffnung", "ouverture", "开口"],
    ["orifice", "orifice", "Blende", "orifice", "节流孔"],
    ["piecewise", "straight pieces", "gerade Stücke", "par morceaux", "分段"],
    ["play", "friction of the spool", "Reibung des Schiebers", "frottement du tiroir", "阀芯摩擦"],
    ["rebound", "rebound", "Zugstufe", "détente", "复原"],
    ["second_order", "second order", "zweite Ordnung", "deuxième ordre", "二阶"],
    ["self_heating", "self-heating", "Eigenerwärmung", "échauffement propre", "自发热"],
    ["simplified", "simplified", "vereinfacht", "simplifiée", "简化"],
    ["slips", "slips at once", "gleitet sofort", "glisse aussitôt", "立即滑移"],
    ["spool", "mass of the spool", "Masse des Schiebers", "masse du tiroir", "阀芯质量"],
    ["stroke", "within each stroke", "in jedem Hub", "à chaque course", "每个行程内"],
    ["table", "table", "Tabelle", "tableau", "表格"],
    ["third_order", "third order", "dritte Ordnung", "troisième ordre", "三阶"],
    ["three_stage", "three stages", "drei Stufen", "trois étages", "三级"],
    ["whole", "whole force", "gesamte Kraft", "effort total", "全部力"],
];

#[cfg(test)]
mod tests {
    use super::super::{DE, EN, FR, ZH};
    use super::*;
    use dashpot_core::parameter;
    use dashpot_core::parameter::Shape;
    use std::collections::BTreeSet;

    #[test]
    fn every_choice_of_the_model_has_a_word_in_every_language_and_none_is_left_over() {
        let of_rows = |shape: Shape| match shape {
            Shape::Choice(words) => words.to_vec(),
            _ => Vec::new(),
        };
        let made: BTreeSet<&str> = parameter::table().flat_map(|row| of_rows(row.parameter.shape)).collect();
        let known: BTreeSet<&str> = CHOICES.iter().map(|choice| choice[0]).collect();
        assert_eq!(known, made);
        assert_eq!(known.len(), CHOICES.len(), "a choice stands twice");
        for choice in CHOICES {
            // They stand in a list of a narrow panel.
            assert!(choice[1..].iter().all(|word| !word.is_empty() && word.chars().count() <= 21), "{choice:?}");
        }
        assert_eq!([&EN, &DE, &FR, &ZH].map(|words| words.choice("groove")), ["groove", "Nut", "rainure", "沟槽"]);
    }
}
