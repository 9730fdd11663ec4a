//! Finds one common sign for all campaigns of a rig.
//!
//! Groups of tests, their reference and the tests compared with them come from one rig with the same wiring. The
//! campaign with the most certain sign therefore determines the uncertain signs of the others.

use super::loading::Campaign;
use crate::cleaning::cycles_of;
use crate::data::record::Note;
use crate::messages::phrases;
use crate::options::Positive;
use crate::tuning::rig_sign::OWN;
use crate::tuning::sign::UNSURE;
use dashpot_messages::{Sentence, format_decimals};

/// Reverses each campaign whose sign differs from the most certain sign, and adds a note. A campaign with a stated
/// direction stays unchanged. A campaign with an opposite but certain direction only gets a note.
pub fn agree_on_sign(campaigns: &mut [&mut Campaign]) {
    let Some(surest) = campaigns.iter().map(|c| &c.sign).max_by(|a, b| a.confidence.total_cmp(&b.confidence)).cloned()
    else {
        return;
    };
    let percent = |confidence: f64| format_decimals(100.0 * confidence, 0);
    let word = |positive: Positive| positive.name();
    for campaign in campaigns {
        let own = campaign.sign.clone();
        if own.is_stated {
            continue;
        }
        if own.positive == surest.positive {
            // If the most certain campaign has the same sign, its confidence applies to this campaign too.
            if surest.confidence >= UNSURE {
                campaign.notes.retain(|note| note.kind != "sign_unsure");
                campaign.sign.confidence = surest.confidence;
            }
            continue;
        }
        let names = campaign.records.iter().take(1).map(|record| record.source.as_str());
        let disagree = |template| {
            Sentence::from(template)
                .with("file", names.clone().next().unwrap_or(""))
                .with_word("own", word(own.positive))
                .with("percent", percent(own.confidence))
                .with_word("other", word(surest.positive))
                .with("sure", percent(surest.confidence))
        };
        if own.confidence >= OWN {
            let text = disagree(phrases::SIGNS_DISAGREE);
            campaign.notes.push(Note { kind: "sign_unsure", text });
            continue;
        }
        let text = disagree(phrases::SIGN_OF_RIG);
        campaign.notes.retain(|note| note.kind != "sign_unsure");
        campaign.sign.reasons.insert(0, text.clone());
        campaign.notes.push(Note { kind: "sign_unsure", text });
        campaign.turn();
        campaign.sign.confidence = surest.confidence;
    }
}

impl Campaign {
    /// Reverses the positive direction of force and motion in every record.
    fn turn(&mut self) {
        self.sign.positive = self.sign.positive.opposite();
        self.sign.standstill_force = -self.sign.standstill_force;
        self.sign.asymmetry = self.sign.asymmetry.map(|ratio| 1.0 / ratio);
        let counted = self.sign.counted();
        for record in &mut self.records {
            for values in [&mut record.force, &mut record.displacement, &mut record.velocity] {
                values.iter_mut().for_each(|value| *value = -*value);
            }
            record.mean_displacement = -record.mean_displacement;
            // Cycles begin at an upward zero crossing, which is a motion toward rebound. After the reversal, they begin
            // at other samples.
            record.cycles = cycles_of(&record.time, &record.displacement);
            record.counted = Some(counted);
            record.frame = record.frame.reversed();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::checks::sign::SignFinding;
    use crate::data::record::Record;
    use crate::fixtures::SineTest;

    fn campaign(positive: Positive, confidence: f64, given: bool) -> Campaign {
        let samples = SineTest::default().samples();
        let record = Record {
            displacement: samples.displacement.unwrap(),
            velocity: samples.velocity.unwrap(),
            time: samples.time,
            force: samples.force,
            ..Record::default()
        };
        let sign = SignFinding {
            positive,
            is_stated: given,
            confidence,
            reasons: Vec::new(),
            standstill_force: -100.0,
            asymmetry: Some(2.0),
        };
        let notes = vec![Note { kind: "sign_unsure", text: phrases::WEAK.into() }];
        Campaign { records: vec![record], sign, delay: None, notes, unusable: Vec::new(), files: Vec::new() }
    }

    #[test]
    fn the_surest_decides_for_those_that_hardly_tell() {
        let mut sure = campaign(Positive::Rebound, 0.97, false);
        let mut weak = campaign(Positive::Compression, 0.6, false);
        let mut same = campaign(Positive::Rebound, 0.6, false);
        let mut given = campaign(Positive::Compression, 1.0, true);
        let (before, force) = (weak.records[0].clone(), given.records[0].force.clone());
        given.sign.confidence = 0.5;
        agree_on_sign(&mut [&mut sure, &mut weak, &mut same, &mut given]);
        assert!(sure.notes.is_empty() && same.notes.is_empty() && same.sign.confidence == 0.97);
        assert_eq!((weak.sign.positive, weak.sign.standstill_force), (Positive::Rebound, 100.0));
        assert!(weak.records[0].force.iter().zip(&before.force).all(|(a, b)| *a == -*b));
        let told = weak.notes[0].text.to_string();
        assert!(told.contains("60 %") && told.contains("97 %") && told.contains("--positive"), "{told}");
        assert!(given.sign.positive == Positive::Compression && given.records[0].force == force);
        // Two campaigns with certain but opposite signs come from two rigs, so neither is reversed.
        let mut other = campaign(Positive::Compression, 0.95, false);
        agree_on_sign(&mut [&mut sure, &mut other]);
        assert!(other.sign.positive == Positive::Compression && other.notes.len() == 2);
    }
}
