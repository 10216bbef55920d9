//! Frames of any kind as JSON, made from the projection alone.

use ncp_proto::{
    contract::Contract,
    projection::{FieldProjection, MessageProjection, Shape, Unknown},
};
use ncp_spec::wire::Kind;
use proptest::{collection::vec, prelude::*, sample::select};
use serde_json::{Map, Value, json};

/// Frames of any kind but the error frame; with values that protobuf cannot carry, or without.
pub(crate) fn frame(lossy: bool) -> impl Strategy<Value = (Kind, String)> {
    let contract = Contract::current().unwrap();
    let frames = contract.kinds().map(|(kind, _, projected)| {
        let kind = Kind::parse(kind).unwrap();
        message(&contract, projected, lossy, false).prop_map(move |frame| (kind, frame.to_string()))
    });
    proptest::strategy::Union::new(frames.map(Strategy::boxed).collect::<Vec<_>>())
}

fn message(contract: &Contract, projected: &MessageProjection, lossy: bool, inside: bool) -> BoxedStrategy<Value> {
    let mut fields: BoxedStrategy<Map<String, Value>> = Just(Map::new()).boxed();
    for (name, field) in &projected.fields {
        let left_out =
            inside && projected.inside_request.as_ref().is_some_and(|inside| inside.may_be_absent.contains(name));
        let required = projected.required.contains(name) && !inside;
        let value = match &field.pinned {
            Some(pinned) => Just(pinned.clone()).boxed(),
            // Inside a request it could only be the request's; left out it is.
            None if left_out => continue,
            None => value(contract, field, lossy),
        };
        let value =
            if required { value.prop_map(Some).boxed() } else { proptest::option::weighted(0.8, value).boxed() };
        let name = name.clone();
        fields = (fields, value)
            .prop_map(move |(mut fields, value)| {
                fields.extend(value.map(|value| (name.clone(), value)));
                fields
            })
            .boxed();
    }
    fields.prop_map(Value::Object).boxed()
}

fn value(contract: &Contract, field: &FieldProjection, lossy: bool) -> BoxedStrategy<Value> {
    if field.segment {
        return "[a-zé神][a-z0-9é神]{0,5}".prop_map(Value::from).boxed();
    }
    if field.encoding.is_some() {
        return select(&["", "TkNQQg==", "AAEC/w==", "////"][..]).prop_map(Value::from).boxed();
    }
    let empty_is_unset = field.ty.nullable && !lossy;
    // Of the fields that hold a message only those of a request are optional.
    let value = shape(contract, &field.ty.shape, lossy, field.ty.nullable)
        .prop_filter("reads back as unset", move |value| {
            !empty_is_unset || (*value != json!("") && value.as_f64() != Some(0.0))
        });
    if field.ty.nullable { prop_oneof![1 => Just(Value::Null), 3 => value].boxed() } else { value.boxed() }
}

fn shape(contract: &Contract, shape_of: &Shape, lossy: bool, inside: bool) -> BoxedStrategy<Value> {
    const MOST: i64 = 9_007_199_254_740_991;
    let string = || prop_oneof![Just(String::new()), "[a-zA-Z /_é神🧠]{1,6}"];
    match shape_of {
        Shape::Integer => {
            prop_oneof![Just(0), Just(MOST), Just(-MOST), -MOST..=MOST, -9..9_i64].prop_map(Value::from).boxed()
        }
        Shape::Number => {
            let zero = if lossy { -0.0 } else { 0.0 };
            prop_oneof![
                Just(zero),
                Just(f64::MAX),
                Just(5e-324),
                Just(0.1),
                any::<f64>().prop_filter("JSON has finite numbers", |x| x.is_finite() && *x != 0.0)
            ]
            .prop_map(Value::from)
            .boxed()
        }
        Shape::String => string().prop_map(Value::from).boxed(),
        Shape::Boolean => any::<bool>().prop_map(Value::from).boxed(),
        Shape::Array(inner) => {
            // In an array a negative zero crosses.
            let negative_zero = matches!(**inner, Shape::Number);
            vec(shape(contract, inner, lossy || negative_zero, false), 0..4).prop_map(Value::from).boxed()
        }
        Shape::Map(inner) => proptest::collection::btree_map(string(), shape(contract, inner, lossy, false), 0..3)
            .prop_map(|map| Value::Object(map.into_iter().collect()))
            .boxed(),
        Shape::Named(name) => match contract.projection.enums.get(name) {
            Some(projected) => {
                let known = select(projected.values.values().cloned().collect::<Vec<_>>());
                let keeps = projected.unknown == Unknown::Keep;
                if lossy && keeps {
                    prop_oneof![4 => known, 1 => string()].prop_map(Value::from).boxed()
                } else {
                    known.prop_map(Value::from).boxed()
                }
            }
            None => message(contract, &contract.projection.messages[name], lossy, inside),
        },
    }
}
