//! Decides which stage of a frame each function belongs to.

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Stage {
    /// Work that is done once a frame.
    Preparation,
    /// Screen bounds and active lists: which shapes the rays of a row can hit.
    Spans,
    /// The ray of a pixel, and its first hit.
    Primary,
    /// Normals, cosines, highlights and colours.
    Shading,
    /// Shadow rays: whether a light is occluded, and which shapes can occlude it.
    Shadow,
    /// The mirrored rays, and their hits.
    Reflection,
    /// From the sum of a path to the pixel on the display.
    Output,
    /// Functions that have no rule and no caller with a rule, and the loop over the reflections.
    Other,
}

/// All stages, in the order of a frame.
pub const STAGES: [Stage; 8] = [
    Stage::Preparation,
    Stage::Spans,
    Stage::Primary,
    Stage::Shading,
    Stage::Shadow,
    Stage::Reflection,
    Stage::Output,
    Stage::Other,
];

impl Stage {
    pub fn name(self) -> String {
        format!("{self:?}").to_lowercase()
    }
}

/// Says which stage the instructions of a function belong to, and those of the functions it calls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rule {
    /// The instructions belong to this stage, unless a called function has its own rule.
    Is(Stage),
    /// The instructions belong to this stage, with those of all called functions, whatever their
    /// rules.
    AllIs(Stage),
    /// The function makes the first ray of a pixel.
    MakesRay,
    /// The function makes the mirrored ray at a surface.
    MirrorsRay,
    /// The function finds the hit of the latest ray.
    Meets,
}

/// The rules of functions, by the beginning of the function's [`path`]. The first rule that matches
/// counts. A function without a rule belongs to its caller's stage.
const RULES: [(&str, Rule); 37] = {
    use Rule::{AllIs, Is, MakesRay, Meets, MirrorsRay};
    use Stage::{Other, Output, Preparation, Shading, Shadow, Spans};
    [
        ("firmware::contestant::Fixed::prepare", AllIs(Preparation)),
        ("firmware", Is(Output)),
        ("reflet::camera::rays::screen_axes", Is(Spans)),
        ("reflet::camera", MakesRay),
        ("reflet::accel::active_list::ActiveList::ask", Meets),
        ("reflet::accel::active_lists::ActiveLists::nearest", Meets),
        ("reflet::accel::active_list", Is(Spans)),
        ("reflet::accel::screen_axis", Is(Spans)),
        ("reflet::accel::screen_bounds", Is(Spans)),
        ("reflet::accel::screen_culling", Is(Spans)),
        ("reflet::accel::screen_rect", Is(Spans)),
        ("reflet::accel::stretch", Is(Spans)),
        ("reflet::accel::light_stretch", Is(Shadow)),
        ("reflet::ray::row_plane", Is(Spans)),
        ("reflet::accel::nearest_ahead", Meets),
        ("reflet::accel::hierarchy::is_blocked", Is(Shadow)),
        ("reflet::accel::hierarchy", Meets),
        ("reflet::accel::light_occluders", Is(Shadow)),
        ("reflet::accel::light_table", Is(Shadow)),
        ("reflet::accel::light_visibility", Is(Shadow)),
        ("reflet::scene::nearest::any_blocks", Is(Shadow)),
        ("reflet::scene::nearest", Meets),
        ("reflet::scene::query::nearest_hit", Meets),
        ("reflet::scene::query::occluded", Is(Shadow)),
        ("reflet::scene::planes::near", Meets),
        ("reflet::scene::far::between", Is(Shadow)),
        ("reflet::scene::surface::Surface::reflect", MirrorsRay),
        ("reflet::scene::surface", Is(Shading)),
        ("reflet::shade", Is(Shading)),
        ("reflet::trace::visibility", Is(Shadow)),
        ("reflet::trace::Tracer::new", Is(Spans)),
        ("reflet::trace", Is(Other)),
        ("reflet::color::Sum::to_rgb8", Is(Output)),
        ("reflet::color", Is(Shading)),
        ("reflet::render::prepared::Rows::tracer", Is(Spans)),
        ("reflet::render", Is(Output)),
        ("reflet::display", Is(Output)),
    ]
};

impl Rule {
    /// Returns the rule of a function, if it has one.
    pub fn of(name: &str) -> Option<Self> {
        let path = path(name);
        let mut rules = RULES.iter();
        let found = rules.find(|(start, _)| path.starts_with(start))?;
        Some(found.1)
    }
}

/// Returns the modules, the type and the name of a function, without generics and traits:
/// `<scene::Static<T> as scene::World>::parts` becomes `scene::Static::parts`.
pub fn path(name: &str) -> String {
    let Some(inside) = name.strip_prefix('<') else {
        let plain: String = outside(name).map(|(_, letter)| letter).collect();
        let plain = plain.replace("::::", "::");
        return plain.trim_end_matches("::").to_owned();
    };
    let close = outside(inside).find(|&(_, letter)| letter == '>');
    let (of, rest) = match close {
        Some((at, _)) => (&inside[..at], &inside[at + 1..]),
        None => (inside, ""),
    };
    let of = of.split(" as ").next().unwrap_or(of);
    path(of.trim_start_matches('&')) + &path(rest)
}

/// Returns the letters of a text that are outside of all angle brackets, with their byte positions.
/// A closing bracket without an opening one counts as outside.
fn outside(text: &str) -> impl Iterator<Item = (usize, char)> {
    let (mut depth, mut before) = (0, ' ');
    text.char_indices().filter(move |&(_, letter)| {
        let is_inside = depth > 0;
        match letter {
            '<' => depth += 1,
            // The `>` of an arrow `->` is no bracket.
            '>' if before != '-' && depth > 0 => depth -= 1,
            _ => {}
        }
        before = letter;
        !is_inside && letter != '<'
    })
}

/// Says which ray of a pixel's path is the latest.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Ray {
    /// The pixel's first ray, not followed yet.
    #[default]
    New,
    /// The camera ray of a pixel.
    First,
    /// A ray after the first reflection.
    Mirrored,
}

impl Ray {
    /// Returns the latest ray after an instruction of a function with this rule. The compiler may
    /// move instructions of the mirrored ray before the first hit; these change nothing.
    pub fn after(self, rule: Option<Rule>) -> Self {
        match (self, rule) {
            (_, Some(Rule::MakesRay)) => Self::New,
            (Self::New, Some(Rule::Meets)) => Self::First,
            (Self::First, Some(Rule::MirrorsRay)) => Self::Mirrored,
            _ => self,
        }
    }
}

/// Returns the stage of an instruction from the rules of its functions, the innermost first.
pub fn stage(rules: impl Iterator<Item = Rule>, ray: Ray) -> Stage {
    let (mut found, mut all) = (None, None);
    for rule in rules {
        let stage = match rule {
            Rule::Is(stage) | Rule::AllIs(stage) => stage,
            Rule::MakesRay => Stage::Primary,
            Rule::MirrorsRay => Stage::Reflection,
            Rule::Meets if ray == Ray::Mirrored => Stage::Reflection,
            Rule::Meets => Stage::Primary,
        };
        found.get_or_insert(stage);
        if let Rule::AllIs(stage) = rule {
            all = Some(stage);
        }
    }
    all.or(found).unwrap_or(Stage::Other)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::root;

    #[test]
    fn path_has_neither_generics_nor_traits() {
        let paths = "
reflet::trace::trace => reflet::trace::trace
reflet::render::Rows<S,Q,K>::colors::{{closure}} => reflet::render::Rows::colors::{{closure}}
<reflet::scene::Static<T> as reflet::scene::World>::parts => reflet::scene::Static::parts
<&W as reflet::scene::World>::parts::<X> => W::parts
reflet::scene::row::<impl reflet::ray::Fan>::column => reflet::scene::row::column
<core::iter::Map<I, fn(u8) -> <A as B>::C> as Iterator>::next => core::iter::Map::next
<reflet::camera::RayGenerator>::screen_axes => reflet::camera::RayGenerator::screen_axes
__aeabi_lmul => __aeabi_lmul
<broken => broken
<A<B> as C => A
a>b<c => a>b";
        for line in paths.trim().lines() {
            let (name, expected) = line.split_once(" => ").unwrap();
            assert_eq!(path(name), expected);
        }
    }

    /// The library's functions are renamed now and then. A rule that matches no function would move
    /// instructions to another stage without an error.
    #[test]
    fn rules_name_what_there_is() {
        for (rule, _) in RULES {
            let (package, rest) = rule.split_once("::").unwrap_or((rule, ""));
            let mut folder = root().join(match package {
                "reflet" => "src",
                "firmware" => "xtask/firmware/src",
                _ => panic!("{rule} names no package"),
            });
            let mut file = folder.join("lib.rs");
            for name in rest.split("::").filter(|name| !name.is_empty()) {
                folder = folder.join(name);
                let modules = [folder.with_extension("rs"), folder.join("mod.rs")];
                if let Some(module) = modules.into_iter().find(|module| module.is_file()) {
                    file = module;
                    continue;
                }
                let text = fs::read_to_string(&file).unwrap();
                let is_there =
                    ["fn ", "struct "].map(|word| text.contains(&(word.to_owned() + name)));
                assert!(
                    is_there.contains(&true),
                    "there is no {name} in {}, as the rule {rule} says",
                    file.display()
                );
            }
        }
    }

    #[test]
    fn rays_are_told_apart_by_what_is_made() {
        let after = |rules: &[Rule]| {
            let ray = |ray: Ray, rule: &Rule| ray.after(Some(*rule)).after(None);
            rules.iter().fold(Ray::default(), ray)
        };
        use Rule::{MakesRay, Meets, MirrorsRay};
        let shades = Rule::Is(Stage::Shading);
        assert_eq!(after(&[MakesRay]), Ray::New);
        assert_eq!(after(&[MakesRay, Meets, shades]), Ray::First);
        // The compiler has moved the mirrored ray up.
        assert_eq!(after(&[MakesRay, MirrorsRay, Meets]), Ray::First);
        assert_eq!(after(&[MakesRay, Meets, MirrorsRay, Meets]), Ray::Mirrored);
        assert_eq!(after(&[MakesRay, Meets, MirrorsRay, MakesRay]), Ray::New);
    }

    #[test]
    fn innermost_rule_says_the_stage_unless_one_is_for_all() {
        let of = |rules: &[Rule], ray| stage(rules.iter().copied(), ray);
        let (spans, output) = (Rule::Is(Stage::Spans), Rule::Is(Stage::Output));
        let all = Rule::AllIs(Stage::Preparation);
        assert_eq!(of(&[spans, output], Ray::First), Stage::Spans);
        assert_eq!(of(&[spans, all, output], Ray::First), Stage::Preparation);
        assert_eq!(of(&[], Ray::First), Stage::Other);
        assert_eq!(of(&[Rule::Meets, output], Ray::First), Stage::Primary);
        assert_eq!(of(&[Rule::Meets, output], Ray::Mirrored), Stage::Reflection);
        assert_eq!(of(&[Rule::MirrorsRay], Ray::First), Stage::Reflection);
    }
}
