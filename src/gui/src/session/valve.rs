//! Response of an adjustable damper's valve to a step of its command. If open tests contain steps, the response comes from them. Otherwise
//! it follows from the parameters of the valve.

use crate::session::Session;
use crate::session::tasks::{Kind, Outcome, Standing, Task};
use dashpot_identification::family::{ActuatorNumber, actuator_numbers};
use dashpot_identification::validation::StepResponse;
use dashpot_messages::Sentence;
use dashpot_records::{Record, SettingPattern};
use dashpot_simulation::step_response::step_responses;
use dashpot_simulation::valve_response::{has_actuator, valve_response};

/// Responses of the force to the steps in the open tests.
#[derive(Default)]
pub struct Responses {
    /// Responses to the steps in the tests. Steps without a measured response are omitted.
    pub of_force: Vec<StepResponse>,
    task: Option<Task>,
}

impl Responses {
    /// Returns whether the computation is running.
    pub fn is_waiting(&self) -> bool {
        self.task.is_some()
    }
}

impl Session {
    /// Returns whether the model is an adjustable damper whose valve has dynamics.
    pub fn has_valve(&self) -> bool {
        self.model.as_ref().and_then(|model| model.definition()).is_some_and(|damper| has_actuator(&damper.axis))
    }

    /// Returns the parameters of the valve.
    pub fn valve_numbers(&self) -> Vec<ActuatorNumber> {
        let Some(model) = &self.model else { return Vec::new() };
        model.definition().map_or_else(Vec::new, |damper| actuator_numbers(&damper.axis, &model.identification))
    }

    /// Returns the response to a step up or down. The step is the largest of the open tests, or else the valve's step over the range of
    /// settings.
    pub fn step_response(&self, is_up: bool) -> Option<StepResponse> {
        let size = |of: &&StepResponse| (of.to - of.from).abs();
        let own = self.responses.of_force.iter().filter(|of| of.is_up() == is_up);
        if let Some(largest) = own.max_by(|a, b| size(a).total_cmp(&size(b))) {
            return Some(largest.clone());
        }
        let axis = &self.model.as_ref()?.definition()?.axis;
        let (low, high) = axis.range();
        if is_up { valve_response(axis, low, high) } else { valve_response(axis, high, low) }
    }

    /// Starts the computation of responses in the background, if the damper has a valve and a test contains steps.
    pub(super) fn order_responses(&mut self) {
        if let Some(task) = self.responses.task.take() {
            task.cancel();
        }
        self.responses = Responses::default();
        let (true, Some(loaded), Some(model)) = (self.has_valve(), self.campaign.clone(), &self.model) else { return };
        let Some(damper) = model.definition().cloned() else { return };
        let has_steps = |record: &Record| {
            record.setting_signal.as_ref().is_some_and(|signal| signal.pattern == SettingPattern::Steps)
        };
        if !loaded.campaign.records.iter().any(has_steps) {
            return;
        }
        self.responses.task = Some(Task::begin(Kind::Respond, self.waker.clone(), move |_| {
            let records: Vec<&Record> = loaded.campaign.records.iter().filter(|record| has_steps(record)).collect();
            let found = step_responses(&damper, &records).map_err(Sentence::as_it_is)?;
            Ok(Outcome::Responded(found))
        }));
    }

    /// Collects completed responses. Returns whether the computation is still running.
    pub(super) fn poll_responses(&mut self) -> bool {
        match self.responses.task.as_ref().map(Task::standing) {
            Some(Standing::Working) => return true,
            Some(Standing::Done(Ok(Outcome::Responded(mut found)))) => {
                found.retain(|of| of.measured.is_some());
                self.responses.of_force = found;
            }
            _ => {}
        }
        self.responses.task = None;
        false
    }
}
