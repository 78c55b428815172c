//! Cover with a bumpy region, where the bumpy block cannot be grasped at its middle.

use super::controllers::{controller, parameters, sample_pick};
use super::world::{Block, Rules, Target, blocks, targets};
use super::{Action, BLOCK_TYPE, Family, TARGET_TYPE, TYPES_WITH_BUMPS, predicates};
use crate::random::uniform_in;
use crate::real::Real;
use crate::task::{
    Controller, ControllerId, Environment, Failure, LiftedAtom, ObjectId, ObjectType, Operator,
    OperatorId, Parameters, Predicate, PredicateId, State,
};
use rand_core::Rng;

/// Where the bumpy region begins; it goes to the end of the table. A block is in it if
/// its pose is beyond.
pub const BUMPY_REGION: f64 = 0.8;

/// How often the sampler draws a place in the bumpy region again.
const MAX_DRAWS: usize = 10_000;

/// The environment `regional_bumpy_cover`. See the [module](super).
///
/// A block has one more number, 1 if it is bumpy: `block0` is, `block1` is not. The
/// framework's operator that is impossible, off by default, is left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct RegionalBumpyCover;

impl RegionalBumpyCover {
    /// `Clear(target)`: no block covers the target.
    pub const CLEAR: PredicateId = PredicateId(0);
    /// `InBumpyRegion(block)`: the block lies in the bumpy region, and is not held.
    pub const IN_BUMPY_REGION: PredicateId = PredicateId(4);
    /// `InSmoothRegion(block)`: the block lies outside of it, and is not held.
    pub const IN_SMOOTH_REGION: PredicateId = PredicateId(5);

    /// `PickFromBumpy(block; p)`: picks a block from the bumpy region by a click at
    /// `p`.
    pub const PICK_FROM_BUMPY: ControllerId = ControllerId(0);
    /// `PickFromSmooth(block; p)`: picks a block from outside of it.
    pub const PICK_FROM_SMOOTH: ControllerId = ControllerId(1);
    /// `PickFromTarget(block, target; p)`: picks a block from the target.
    pub const PICK_FROM_TARGET: ControllerId = ControllerId(2);
    /// `PlaceOnBumpy(block; p)`: puts the block into the bumpy region.
    pub const PLACE_ON_BUMPY: ControllerId = ControllerId(3);
    /// `PlaceOnTarget(block, target; p)`: puts the block over the target.
    pub const PLACE_ON_TARGET: ControllerId = ControllerId(4);
}

static RULES: Rules = Rules {
    reaches: |state, p| {
        if blocks(state).any(|block| block.is_held()) {
            return (0.0..=1.0).contains(&p);
        }
        let can_grasp = |block: Block| {
            let (left, right) = block.extent().into_inner();
            if !(is_bumpy(state, block.object) && block.pose > BUMPY_REGION) {
                return (left..=right).contains(&p);
            }
            let third = (right - left) / 3.0;
            (left..=third + left).contains(&p) || (2.0 * third + left..=right).contains(&p)
        };
        let on_target = |target: Target| target.extent().contains(&p);
        blocks(state).any(can_grasp) || targets(state).any(on_target)
    },
    supports: |_, _| true,
};

fn is_bumpy(state: &State, block: ObjectId) -> bool {
    let bumpy = state.get(block).map(|[.., bumpy]: &[f64; 6]| *bumpy);
    bumpy.is_some_and(|bumpy| Real::abs(bumpy - 1.0) < 1e-3)
}

/// Whether a block lies in the bumpy region; `None` if it is held.
fn is_in_bumpy_region(state: &State, objects: &[ObjectId]) -> Option<bool> {
    let block = Block::read(state, *objects.first()?)?;
    (!block.is_held()).then_some(block.pose > BUMPY_REGION)
}

const IS_SMOOTH: LiftedAtom<'static> = LiftedAtom::new(RegionalBumpyCover::IN_SMOOTH_REGION, &[0]);
const IS_ROUGH: LiftedAtom<'static> = LiftedAtom::new(RegionalBumpyCover::IN_BUMPY_REGION, &[0]);
const IS_CLEAR: LiftedAtom<'static> = LiftedAtom::new(RegionalBumpyCover::CLEAR, &[1]);

impl Family for RegionalBumpyCover {
    const COVERS: PredicateId = PredicateId(1);
    const HAND_EMPTY: PredicateId = PredicateId(2);
    const HOLDING: PredicateId = PredicateId(3);
    const IS_BLOCK: PredicateId = PredicateId(6);
    const IS_TARGET: PredicateId = PredicateId(7);
}

impl Environment for RegionalBumpyCover {
    type Action = Action;

    const TYPES: &'static [ObjectType] = &TYPES_WITH_BUMPS;
    const PREDICATES: &'static [Predicate<Self>] = &[
        predicates::clear(),
        predicates::covers(),
        predicates::hand_empty(),
        predicates::holding(),
        Predicate {
            name: "InBumpyRegion",
            arguments: &[BLOCK_TYPE],
            classifier: |_, state, objects| is_in_bumpy_region(state, objects) == Some(true),
        },
        Predicate {
            name: "InSmoothRegion",
            arguments: &[BLOCK_TYPE],
            classifier: |_, state, objects| is_in_bumpy_region(state, objects) == Some(false),
        },
        predicates::is_block(),
        predicates::is_target(),
    ];
    const CONTROLLERS: &'static [Controller<Self>] = &[
        controller("PickFromBumpy", &[BLOCK_TYPE]),
        controller("PickFromSmooth", &[BLOCK_TYPE]),
        controller("PickFromTarget", &[BLOCK_TYPE, TARGET_TYPE]),
        controller("PlaceOnBumpy", &[BLOCK_TYPE]),
        controller("PlaceOnTarget", &[BLOCK_TYPE, TARGET_TYPE]),
    ];
    const OPERATORS: &'static [Operator<'static>] = &[
        Operator {
            name: "PickFromBumpy",
            parameters: &[BLOCK_TYPE],
            preconditions: &[Self::NOTHING_HELD, IS_ROUGH],
            add_effects: &[Self::HELD],
            delete_effects: &[Self::NOTHING_HELD, IS_ROUGH],
            controller: Self::PICK_FROM_BUMPY,
            controller_arguments: &[0],
        },
        Operator {
            name: "PickFromSmooth",
            parameters: &[BLOCK_TYPE],
            preconditions: &[Self::NOTHING_HELD, IS_SMOOTH],
            add_effects: &[Self::HELD],
            delete_effects: &[Self::NOTHING_HELD, IS_SMOOTH],
            controller: Self::PICK_FROM_SMOOTH,
            controller_arguments: &[0],
        },
        Operator {
            name: "PickFromTarget",
            parameters: &[BLOCK_TYPE, TARGET_TYPE],
            preconditions: &[Self::COVERED, Self::NOTHING_HELD, IS_SMOOTH],
            add_effects: &[Self::HELD, IS_CLEAR],
            delete_effects: &[Self::COVERED, Self::NOTHING_HELD, IS_SMOOTH],
            controller: Self::PICK_FROM_TARGET,
            controller_arguments: &[0, 1],
        },
        Operator {
            name: "PlaceOnBumpy",
            parameters: &[BLOCK_TYPE],
            preconditions: &[Self::HELD],
            add_effects: &[Self::NOTHING_HELD, IS_ROUGH],
            delete_effects: &[Self::HELD],
            controller: Self::PLACE_ON_BUMPY,
            controller_arguments: &[0],
        },
        Operator {
            name: "PlaceOnTarget",
            parameters: &[BLOCK_TYPE, TARGET_TYPE],
            preconditions: &[Self::HELD, IS_CLEAR],
            add_effects: &[Self::NOTHING_HELD, IS_SMOOTH, Self::COVERED],
            delete_effects: &[Self::HELD, IS_CLEAR],
            controller: Self::PLACE_ON_TARGET,
            controller_arguments: &[0, 1],
        },
    ];

    fn simulate(&self, state: &mut State, action: Action) -> Result<(), Failure> {
        RULES.click(state, f64::from(action))
    }

    /// Picks a block anywhere, bumpy or not; puts it exactly centred over a target; and
    /// for the bumpy region draws a free pose, but clicks there as if the block were
    /// held at its centre.
    fn sample<G: Rng>(
        &self,
        operator: OperatorId,
        state: &State,
        objects: &[ObjectId],
        rng: &mut G,
    ) -> Parameters {
        let draw = |controller, block: Block, target: Option<Target>| match controller {
            Self::PICK_FROM_BUMPY | Self::PICK_FROM_SMOOTH | Self::PICK_FROM_TARGET => {
                Some(sample_pick(&block, rng))
            }
            Self::PLACE_ON_BUMPY => Some(sample_in_bumpy_region(state, &block, rng)),
            Self::PLACE_ON_TARGET => Some(target?.pose + block.grasp),
            _ => None,
        };
        parameters::<Self>(operator, state, objects, draw)
    }
}

/// A pose of a block in the bumpy region apart from the other blocks; the last one
/// that was drawn if there seems to be none.
fn sample_in_bumpy_region(state: &State, block: &Block, rng: &mut impl Rng) -> f64 {
    let half = block.width / 2.0;
    let mut draw = || uniform_in(rng, BUMPY_REGION + half, 1.0 - half);
    let is_free = |pose: f64| {
        let mut others = blocks(state).filter(|other| other.object != block.object);
        others.all(|other| Real::abs(other.pose - pose) > half + other.width / 2.0)
    };
    let mut pose = draw();
    for _ in 0..MAX_DRAWS {
        if is_free(pose) {
            break;
        }
        pose = draw();
    }
    pose
}
