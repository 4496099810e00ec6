use super::*;

#[test]
fn every_name_leads_to_the_scene_of_that_name() {
    struct Name;

    impl Visitor for Name {
        type Output = &'static str;

        fn visit<S: BuiltIn>(self) -> &'static str {
            S::NAME
        }
    }

    for name in NAMES {
        assert_eq!(visit(name, Name), Some(name));
    }
}
