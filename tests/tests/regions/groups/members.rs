//! Instances with any number of members, from none to those that make more ends of intervals
//! than there is room for.

use super::{POSTS, posts};
use critreg::Error;
use critreg::domain::Domain;
use critreg::random::{generator, uniform_in};
use critreg::region::{Intersection, Part, Region};
use critreg_tests::by_hand::{TEXT, World};

#[test]
fn one_region_serves_any_number_of_members() {
    let domain = Domain::parse(POSTS).unwrap();
    assert_eq!(domain.instance_len(), 12);
    let far = Region::parse(&domain, "min(dist(hand, post)) >= 0.5").unwrap();
    let right = Region::parse(&domain, "hand.x > max(post.x)").unwrap();
    type Case<'c> = (&'c [f64], &'c [[f64; 2]], &'c [[f64; 2]]);
    let cases: [Case<'_>; 4] = [
        (&[], &[[0.0, 10.0]], &[[0.0, 10.0]]),
        (&[4.0], &[[0.0, 3.5], [4.5, 10.0]], &[[4.0, 10.0]]),
        (
            &[8.0, 1.0, 1.25],
            &[[0.0, 0.5], [1.75, 7.5], [8.5, 10.0]],
            &[[8.0, 10.0]],
        ),
        (
            &[0.0, 9.0, 7.0, 5.0, 3.0, 10.5],
            &[[0.5, 2.5], [3.5, 4.5], [5.5, 6.5], [7.5, 8.5], [9.5, 10.0]],
            &[],
        ),
    ];
    for (places, when_far, when_right) in cases {
        let instance = posts(places);
        for (region, expected) in [(&far, when_far), (&right, when_right)] {
            let grounded = region.ground::<f64>(&domain, &instance).unwrap();
            let set = grounded.intervals().unwrap();
            let ends: Vec<_> = set.intervals().iter().map(|i| [i.low, i.high]).collect();
            assert!(set.is_exact());
            assert_eq!(ends, expected, "{places:?}");
        }
    }
}

#[test]
fn more_ends_than_there_is_room_for_make_a_larger_set() {
    let domain = Domain::parse(POSTS).unwrap();
    let rings = |count: i32| -> Vec<String> {
        let radius = |i: i32| f64::from(i) / 10.0;
        let ring = |i| format!("min(dist(hand, post)) > {}", radius(i));
        (1..=count).map(ring).collect()
    };
    // Two ends for each of six posts and each ring, and two of the line.
    let region = |count| Region::parse(&domain, &rings(count).join(" or ")).unwrap();
    let instance = posts(&[0.9, 2.5, 4.1, 5.7, 7.3, 8.9]);
    for (count, exact) in [(5, true), (6, false)] {
        let region = region(count);
        let grounded = region.ground::<f64>(&domain, &instance).unwrap();
        let set = grounded.intervals().unwrap();
        assert_eq!(set.is_exact(), exact);
        // The smallest ring decides.
        for step in 0..990 {
            let x = f64::from(step) / 100.0 + 0.003;
            let nearest = [0.9, 2.5, 4.1, 5.7, 7.3, 8.9].map(|post: f64| (post - x).abs());
            let inside = nearest.iter().all(|distance| *distance > 0.1);
            assert_eq!(grounded.contains(&[x]), Ok(inside), "{x}");
            assert!(set.contains(x) || !inside, "{x}");
        }
    }
}

#[test]
fn emptiness_over_no_members_is_proven() {
    let text = POSTS.replace("reach in", "height in [-1, 1]: length parameter reach in");
    let text = text.replace("(reach, 0)", "(reach, height)");
    let domain = Domain::parse(&text).unwrap();
    let near = Region::parse(&domain, "min(dist(hand, post)) <= 20").unwrap();
    let nobody = near.sample::<f64>(&domain, &posts(&[]), &mut generator(1));
    assert_eq!(nobody, Err(Error::EmptyRegion));
    let one = near.sample::<f64>(&domain, &posts(&[3.0]), &mut generator(1));
    assert!(one.is_ok());
}

#[test]
fn a_member_is_absent_as_a_whole() {
    let domain = Domain::parse(TEXT).unwrap();
    let region = Region::parse(&domain, "min(dist(grasp, obstacle)) >= 0.1").unwrap();
    let present = World {
        stick: [0.0; 3],
        obstacles: [Some([5.0; 4]); 6],
        buttons: [None; 3],
    };
    let instance = present.instance();
    assert_eq!(domain.check_instance(&instance), Ok(()));
    for slot in 0..instance.len() {
        for wrong in [f64::NAN, f64::INFINITY] {
            let mut damaged = instance.clone();
            damaged[slot] = wrong;
            let drawn = region.sample::<f64>(&domain, &damaged, &mut generator(1));
            // The only NaN that may stay are those of absent buttons.
            if slot >= 27 && wrong.is_nan() {
                assert!(drawn.is_ok());
            } else {
                assert!(matches!(drawn, Err(Error::NotFinite(_))), "{slot}");
            }
        }
    }
}

const ROW: &str = "
    object post[6] { x: length, y: length }
    parameter reach in [0, 12]: length
    point hand = world + (reach, 0)
";

/// A region of so many constraints about the distance of every post has up to twelve roots
/// for each: more than there is room for. It can be used all the same.
#[test]
fn a_region_with_many_roots_can_be_used() {
    let domain = Domain::parse(ROW).unwrap();
    let mut rng = generator(7);
    for constraints in 1..=12 {
        let bound = |index: usize| match index % 2 {
            0 => format!("min(dist(hand, post)) >= {}", 0.3 + 0.02 * index as f64),
            // Around each post a ring is left out.
            _ => format!(
                "(min(dist(hand, post)) >= {} or min(dist(hand, post)) <= {})",
                0.2 + 0.001 * index as f64,
                0.1 + 0.002 * index as f64
            ),
        };
        let text: Vec<String> = (0..constraints).map(bound).collect();
        let text = text.join(if constraints % 3 == 0 {
            " or "
        } else {
            " and "
        });
        let region = Region::parse(&domain, &text).unwrap();
        for _ in 0..10 {
            let x = |post: usize| 0.5 + 2.0 * post as f64;
            let posts = (0..6).flat_map(|post| [x(post), uniform_in(&mut rng, -0.2, 0.2)]);
            let instance: Vec<f64> = posts.collect();
            let grounded = region.ground::<f64>(&domain, &instance).unwrap();
            let set = grounded.intervals().unwrap();
            let mut some = false;
            for step in 0..=600 {
                let theta = [0.02 * f64::from(step)];
                let inside = grounded.contains(&theta).unwrap();
                assert_eq!(
                    region.contains::<f64>(&domain, &instance, &theta),
                    Ok(inside)
                );
                some |= inside;
                assert!(!inside || set.contains(theta[0]), "{text}: {theta:?}");
            }
            assert!(!(some && grounded.is_proven_empty().unwrap()), "{text}");
            match grounded.sample(&mut rng) {
                Ok(drawn) => assert_eq!(grounded.contains(&drawn[..1]), Ok(true)),
                Err(error) => assert!(!some && error == Error::EmptyRegion, "{text}: {error}"),
            }
            let part = Part {
                region: &region,
                domain: &domain,
                instance: &instance,
            };
            let both = Intersection::<f64>::new(&[part, part])
                .unwrap()
                .sample(&mut rng);
            assert_eq!(both.is_ok(), some, "{text}");
        }
    }
}
