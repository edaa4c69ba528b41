//! The blocks: one file each, in folders by kind, and the registry that names them all.
//!
//! Adding a block is one file and one line in [`REGISTRY`]; the tests of this room walk the registry.

mod body;
mod builder;
mod describe;
mod gate;

pub mod arithmetic;
pub mod logic;
pub mod memory;
pub mod pulses;
pub mod routing;
pub mod timing;

pub use body::{Body, InnerSignal};
pub use builder::{Builder, Held};
pub use describe::{Description, Direction, Kind, Parameter, Parameters, PortDescription, Width};
pub use gate::Gate;

/// A block: what it is called, what it connects to, and how it is made of ops.
///
/// There is no second, hand-written behaviour anywhere: every engine and the Verilog printer take their
/// meaning from what [`Block::build`] returns.
pub trait Block: Sync {
    /// Name, ports, parameters, documentation.
    fn description(&self) -> &'static Description;

    /// What is wrong with a set of parameters although each is within its range, if anything, as a sentence
    /// that says what to change.
    ///
    /// # Errors
    /// The sentence.
    fn check(&self, parameters: &Parameters) -> Result<(), String>;

    /// Builds the block out of ops, for parameters that are within their ranges and pass [`Block::check`].
    fn build(&self, b: &mut Builder);
}

impl std::fmt::Debug for dyn Block {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.description().name)
    }
}

/// Every block there is, by kind and then by name.
pub static REGISTRY: &[&dyn Block] = &[
    &arithmetic::acceleration_meter::AccelerationMeter,
    &arithmetic::delay_regulator::DelayRegulator,
    &arithmetic::difference_circuit::DifferenceCircuit,
    &arithmetic::diode_approximator::DiodeApproximator,
    &arithmetic::divider::Divider,
    &arithmetic::integrator::Integrator,
    &arithmetic::limit_inverter::LimitInverter,
    &arithmetic::multiplier::Multiplier,
    &arithmetic::ones_complement_accumulator::OnesComplementAccumulator,
    &arithmetic::reference::Reference,
    &arithmetic::rounder::Rounder,
    &arithmetic::square_rooter::SquareRooter,
    &arithmetic::squaring_circuit::SquaringCircuit,
    &arithmetic::summer::Summer,
    &arithmetic::summer_3::Summer3,
    &arithmetic::summer_4::Summer4,
    &arithmetic::vector_magnitude::VectorMagnitude,
    &arithmetic::velocity_compensator::VelocityCompensator,
    &logic::decoder::Decoder,
    &logic::direction_control::DirectionControl,
    &logic::order::Order,
    &logic::phase_detector::PhaseDetector,
    &logic::polarity_detector::PolarityDetector,
    &memory::binary_counter::BinaryCounter,
    &memory::checksum::Checksum,
    &memory::lfsr::Lfsr,
    &memory::presettable_memory::PresettableMemory,
    &memory::register::Register,
    &memory::reversible_counter::ReversibleCounter,
    &memory::rom::ReadOnlyMemory,
    &memory::shift_register::ShiftRegister,
    &memory::subtracting_counter::SubtractingCounter,
    &memory::table_memory::TableMemory,
    &memory::trajectory_counter::TrajectoryCounter,
    &memory::trigger::Trigger,
    &pulses::binary_rate_multiplier::BinaryRateMultiplier,
    &pulses::pulse_interleaver::PulseInterleaver,
    &pulses::pulse_switch::PulseSwitch,
    &pulses::sn7497::Sn7497,
    &routing::bipolar_gate::BipolarGate,
    &routing::bound_switch::BoundSwitch,
    &routing::data_switch::DataSwitch,
    &routing::multiplexer::Multiplexer,
    &routing::polarity_gate::PolarityGate,
    &routing::quadrant_switch::QuadrantSwitch,
    &routing::strobe_switch::StrobeSwitch,
    &timing::clock_generator::ClockGenerator,
    &timing::delay_element::DelayElement,
    &timing::half_clock_delay::HalfClockDelay,
    &timing::programmable_delay::ProgrammableDelay,
    &timing::pulse_distributor::PulseDistributor,
    &timing::rank_sequencer::RankSequencer,
    &timing::stop_switch::StopSwitch,
    &timing::two_phase_clock::TwoPhaseClock,
];

/// The block of a name.
#[must_use]
pub fn find(name: &str) -> Option<&'static dyn Block> {
    REGISTRY.iter().copied().find(|block| block.description().name == name)
}

#[cfg(test)]
pub(crate) mod bench;
#[cfg(test)]
mod tests;
