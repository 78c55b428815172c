//! Regions that are wrong cost no plan.

use super::{NODES, draw_from, guided, know, observe, plan};
use critreg::env::stick_button::{ROBOT, STICK};
use critreg::plan::{Conclusion, Draw, Drawn, Planned, Skeleton, Spent, Unguided};
use critreg::random::{Generator, generator};
use critreg::skill::RegionSampler;
use critreg::task::{GroundOperator, State};
use critreg_tests::pick::ENVIRONMENT;
use critreg_tests::plan::skills::{SkillRoom, tasks};
use critreg_tests::plan::{Grounding, Room, record};

/// What there was to spend without advice, and the plan.
fn end(planned: &Planned<'_, State>) -> (Conclusion, Spent, Vec<u16>) {
    let metrics = &planned.metrics;
    let before = metrics.advised.unwrap_or_default();
    let spent = Spent {
        samples: metrics.samples - before.samples,
        skeletons: metrics.skeletons - before.skeletons,
    };
    let plan = planned.steps.iter().map(|step| step.operator).collect();
    (planned.conclusion, spent, plan)
}

#[test]
fn wrong_regions_cost_no_plan() {
    let mut room = Room::new(NODES);
    let mut skill_room = SkillRoom::default();
    let wrong: [[&str; 4]; 4] = [
        ["mu >= 0.9", "", "", ""],
        ["grasp.y >= 2.9", "button.y >= 3", "o >= 0.9", ""],
        ["", "button.y <= 0", "", "mu > 2"],
        ["not true", "not true", "not true", "not true"],
    ];
    let (mut anew, mut solved) = (0, 0);
    for regions in wrong {
        let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
        observe(&mut skills);
        know(&mut skills, &regions);
        for run in record::runs().step_by(7) {
            let grounding = Grounding::new(&ENVIRONMENT, &run.task).unwrap();
            let original = (grounding.simulated(), Unguided);
            let original = end(&plan(&run.task, &grounding, original, &mut room));
            let planned = plan(&run.task, &grounding, guided(&skills, &run.task), &mut room);
            if planned.metrics.advised.is_some() {
                anew += 1;
                assert_eq!(end(&planned), original, "{}", run.name);
            }
            let kept = planned.conclusion == Conclusion::Solved;
            assert!(kept || original.0 != Conclusion::Solved, "{}", run.name);
            solved += u32::from(kept);
        }
    }
    assert!(anew > 50 && solved > 50, "{anew} {solved}");
}

#[test]
fn draws_from_everything_reach_what_a_region_leaves_out() {
    let mut skill_room = SkillRoom::default();
    let mut skills = skill_room.lend(&ENVIRONMENT).unwrap();
    know(&mut skills, &["mu <= 0.25", "", "", ""]);
    let task = &tasks(2, 1..=1, 1)[0];
    let grounding = Grounding::new(&ENVIRONMENT, task).unwrap();
    let is_pick = |o: &GroundOperator| o.objects.as_slice() == [ROBOT, STICK];
    let place = grounding.operators.iter().position(is_pick).unwrap() as u16;
    let outside = |everywhere: f64| {
        let mut sampler = RegionSampler::new(&ENVIRONMENT, &skills);
        sampler.everywhere = everywhere;
        let places = [place];
        let skeleton = Skeleton::new(&grounding.operators, &places);
        let mut rng: Generator = generator(1);
        let beyond = (0..2000).filter(|_| {
            let draw = Draw {
                skeleton,
                step: 0,
                operator: skeleton.get(0).unwrap(),
                state: &task.initial,
                attempt: 1,
                advised: true,
            };
            match draw_from(&mut sampler, &draw, &mut rng) {
                Drawn::Parameters(p) | Drawn::Informed(p) => p[0] > 0.25,
                Drawn::Empty(_) | Drawn::Nothing => panic!("the region is not empty"),
            }
        });
        beyond.count()
    };
    assert_eq!(outside(0.0), 0);
    assert!(
        outside(0.2).abs_diff(300) < 60,
        "a fifth of the draws, three quarters of them"
    );
}
