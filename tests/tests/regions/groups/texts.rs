//! What is wrong with a text about groups is said, and where.

use critreg::Error;
use critreg::domain::Domain;
use critreg::region::Region;
use critreg_tests::by_hand::TEXT;

#[test]
fn errors_of_groups_say_where() {
    let domains = [
        ("object a[0] { x: length }", 1, 10),
        ("object a[1.5] { x: length }", 1, 10),
        ("object a[b] { x: length }", 1, 10),
        ("object a[2 { x: length }", 1, 12),
        ("object a[2] {}", 1, 13),
        ("object a[2] { x: length } object a { x: length }", 1, 34),
        (
            "object a[2] { x: length, y: length } parameter m in [0, 1]: length\npoint p = a + (m, 0)",
            2,
            11,
        ),
        (
            "object a[2] { x: length, y: length } object b[2] { x: length }\npoint p = a + (b.x, 0)",
            2,
            16,
        ),
        (
            "object a[2] { x: length, y: length }\npoint p = world + (a.x, 0)",
            2,
            20,
        ),
        (
            "object a[2] { x: length, y: length }\npoint p = world + (min(a.x), 0)",
            2,
            20,
        ),
        ("object min { x: length }", 1, 8),
    ];
    for (text, line, column) in domains {
        let Err(Error::Syntax(at)) = Domain::parse(text) else {
            panic!("accepted: {text}")
        };
        assert_eq!((at.line, at.column), (line, column), "{text}: {}", at.what);
    }
    let domain = Domain::parse(TEXT).unwrap();
    let regions = [
        ("mu < 1 and\n dist(grasp, obstacle) > 1", 2, 2),
        ("obstacle.x > 1", 1, 1),
        ("grasp.y < obstacle.tip.y", 1, 11),
        ("min(grasp.y) > 1", 1, 5),
        ("min(dist(obstacle, button)) > 1", 1, 5),
        ("min(1) > 1", 1, 5),
        ("min(min(obstacle.x)) > 1", 1, 5),
        ("min(obstacle.x + 1) > 1", 1, 16),
        ("min obstacle.x > 1", 1, 5),
        ("max(area(button)) > 1", 1, 5),
    ];
    for (text, line, column) in regions {
        let Err(Error::Syntax(at)) = Region::parse(&domain, text) else {
            panic!("accepted: {text}")
        };
        assert_eq!((at.line, at.column), (line, column), "{text}: {}", at.what);
    }
    // A shape is the same for every member, so its area needs no extreme.
    assert!(Region::parse(&domain, "area(button) < 1").is_ok());
}

#[test]
fn more_members_than_there_is_room_for() {
    let full = [
        String::from("object a[1000000000000] { x: length }"),
        String::from("object a[33] { x: length }"),
        String::from("object a[22], b[11]: t").replacen("object", "type t { x: length } object", 1),
        (0..9)
            .map(|i| format!("object a{i}[2] {{ x: length }}\n"))
            .collect(),
        String::from("object a[20] { x: length, y: length } shape a = circle(1)"),
    ];
    for text in full {
        let parsed = Domain::parse(&text);
        assert!(matches!(parsed, Err(Error::CapacityExceeded(_))), "{text}");
    }
    let most = Domain::parse("object a[32] { x: length, y: length }").unwrap();
    assert_eq!(most.members(0).len(), 32);
}
