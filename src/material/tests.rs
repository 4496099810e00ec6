use super::*;

#[test]
fn each_field_out_of_range_is_named() {
    let made = |values: [f64; 8]| {
        let [
            red,
            green,
            blue,
            ambient,
            diffuse,
            specular,
            shininess,
            mirror,
        ] = values;
        Material::from_numbers(
            [red, green, blue],
            ambient,
            diffuse,
            (specular, shininess),
            mirror,
        )
    };
    let good = [0.5, 0.5, 0.5, 0.2, 0.8, 0.1, 4.0, 0.3];
    assert!(made(good).is_ok());
    let faults = [
        ErrorKind::Color,
        ErrorKind::Color,
        ErrorKind::Color,
        ErrorKind::Ambient,
        ErrorKind::Diffuse,
        ErrorKind::Specular,
        ErrorKind::Shininess,
        ErrorKind::Mirror,
    ];
    for (field, fault) in faults.into_iter().enumerate() {
        for wrong in [-0.001, 1.1e6, f64::NAN, f64::INFINITY] {
            let mut values = good;
            values[field] = wrong;
            assert_eq!(
                made(values).map_err(|it| it.kind()),
                Err(fault),
                "field {field} = {wrong}"
            );
        }
    }
}
