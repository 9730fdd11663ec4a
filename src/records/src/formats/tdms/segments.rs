//! Segments of a TDMS file. Each segment adds properties to objects, and raw data to some objects.

use std::collections::HashMap;

use super::value::{Cursor, Number, Property};
use crate::source::Budget;

/// Largest number of objects of a file. A rig has tens of channels, but some files have one group for each test.
const MOST: usize = 1 << 14;
/// Memory of an object or a property in addition to its name, bytes. It is also the work of finding the object or
/// property.
const OBJECT: u64 = 256;
/// Flags of a segment: it has metadata, a new list of objects, raw data, interleaved values, big-endian numbers, or raw
/// data of a DAQmx device.
const META: u32 = 1 << 1;
const NEW_LIST: u32 = 1 << 2;
const RAW: u32 = 1 << 3;
const INTERLEAVED: u32 = 1 << 5;
const BIG_ENDIAN: u32 = 1 << 6;
const DAQMX: u32 = 1 << 7;
/// Length of the lead-in before every segment, bytes.
const LEAD_IN: usize = 28;

/// A channel with its physical values.
#[derive(Debug, Default)]
pub(super) struct Channel {
    pub group: String,
    pub name: String,
    /// Unit; may be empty.
    pub unit: String,
    /// Time step of the channel's waveform, s.
    pub step: Option<f64>,
    /// Time of the channel's first value, s since 1970, if known.
    pub begins: Option<f64>,
    pub values: Vec<f64>,
}

/// An object of a TDMS file (the file itself, a group or a channel) with its properties and data.
#[derive(Debug, Default)]
struct Object {
    path: String,
    properties: HashMap<String, Property>,
    /// Layout of the object's data in a segment: type of number, and number of values in a chunk.
    index: Option<(Number, usize)>,
    /// Whether the object has data in the segment.
    is_active: bool,
    values: Vec<f64>,
}

/// Reads all channels of a file. Also returns whether the file is truncated.
pub(super) fn channels(bytes: &[u8], budget: &Budget) -> Result<(Vec<Channel>, bool), String> {
    if !bytes.starts_with(b"TDSm") {
        return Err("it does not begin with TDSm".into());
    }
    let mut objects: Vec<Object> = Vec::new();
    let mut by_path: HashMap<String, usize> = HashMap::new();
    // Objects with data in the segment, in the order of their data. The next segment may refer to the same list.
    let mut active: Vec<usize> = Vec::new();
    let (mut at, mut cut) = (0, false);
    while at + LEAD_IN <= bytes.len() {
        let lead = &bytes[at..at + LEAD_IN];
        if &lead[..4] != b"TDSm" {
            return Err(format!("at byte {at} no segment begins"));
        }
        let flags = u32::from_le_bytes(lead[4..8].try_into().unwrap_or_default());
        let mut rest = Cursor::new(&lead[8..], flags & BIG_ENDIAN != 0);
        let _version = rest.u32()?;
        let (next, raw) = (rest.u64()?, rest.u64()?);
        let from = at + LEAD_IN;
        // The last segment of an interrupted recording does not state its end.
        let end = if next == u64::MAX {
            Some(bytes.len())
        } else {
            usize::try_from(next).ok().and_then(|n| from.checked_add(n))
        };
        // In a truncated file, missing data are left out, but missing properties are an error.
        let stated = end.ok_or("a segment ends outside the file")?;
        cut |= next == u64::MAX || stated > bytes.len();
        let end = stated.min(bytes.len());
        let raw = usize::try_from(raw).ok().and_then(|n| from.checked_add(n)).filter(|raw| *raw <= end);
        let raw = raw.ok_or("a segment's data begin outside the segment")?;
        if flags & DAQMX != 0 {
            return Err("it holds raw data of a DAQmx device; save it again with scaled values".into());
        }
        if flags & META != 0 {
            if flags & NEW_LIST != 0 {
                active.drain(..).for_each(|k| objects[k].is_active = false);
            }
            let mut cursor = Cursor::new(&bytes[from..raw], flags & BIG_ENDIAN != 0);
            meta(&mut cursor, &mut objects, &mut by_path, &mut active, budget)?;
        }
        if flags & RAW != 0 {
            cut |= data(&bytes[raw..end], flags, &mut objects, &active, budget)?;
        }
        at = end;
    }
    // The file ends within the lead-in of a segment.
    cut |= at < bytes.len();
    let channels = objects.into_iter().filter_map(|object| channel(object).transpose()).collect::<Result<_, _>>()?;
    Ok((channels, cut))
}

/// Reads the objects in the metadata of a segment.
fn meta(
    cursor: &mut Cursor<'_>,
    objects: &mut Vec<Object>,
    by_path: &mut HashMap<String, usize>,
    active: &mut Vec<usize>,
    budget: &Budget,
) -> Result<(), String> {
    for _ in 0..cursor.u32()? {
        let path = cursor.text()?;
        budget.work(OBJECT)?;
        let place = match by_path.get(&path) {
            Some(place) => *place,
            None => {
                if objects.len() == MOST {
                    return Err(format!("it has more than {MOST} objects"));
                }
                budget.hold(2 * path.len() as u64 + OBJECT)?;
                by_path.insert(path.clone(), objects.len());
                objects.push(Object { path, ..Object::default() });
                objects.len() - 1
            }
        };
        let has_data = match cursor.u32()? {
            u32::MAX => false,
            0 => objects[place].index.is_some(),
            0x1269 | 0x1369 | 0x6912_0000 | 0x6913_0000 => {
                return Err("it holds raw data of a DAQmx device; save it again with scaled values".into());
            }
            _ => {
                let (code, dimension, count) = (cursor.u32()?, cursor.u32()?, cursor.u64()?);
                if code == 0x20 {
                    return Err(format!("{} holds texts, which are not read beside numbers", objects[place].path));
                }
                let number = Number::from_code(code).ok_or_else(|| {
                    format!("{} holds values of the type {code:#x}, which are not read", objects[place].path)
                })?;
                let count = usize::try_from(count).ok().filter(|_| dimension == 1);
                let count =
                    count.ok_or_else(|| format!("{} announces more than any file holds", objects[place].path))?;
                objects[place].index = Some((number, count));
                true
            }
        };
        if has_data && !objects[place].is_active {
            objects[place].is_active = true;
            active.push(place);
        }
        for _ in 0..cursor.u32()? {
            let name = cursor.text()?;
            let value = cursor.property()?;
            budget.hold(name.len() as u64 + value.size() + OBJECT)?;
            objects[place].properties.insert(name, value);
        }
    }
    Ok(())
}

/// Reads the data of a segment. Returns whether its last chunk is incomplete. A chunk contains the values of all
/// objects, either object after object or interleaved value by value.
fn data(bytes: &[u8], flags: u32, objects: &mut [Object], active: &[usize], budget: &Budget) -> Result<bool, String> {
    // A segment that refers to an earlier list is short but costs as much as a segment with its own list.
    budget.work(10 * active.len() as u64)?;
    let shapes: Vec<(usize, Number, usize)> = active
        .iter()
        .filter_map(|k| objects[*k].index.map(|(number, count)| (*k, number, count)))
        .filter(|(_, _, count)| *count > 0)
        .collect();
    let size = |(_, number, count): &(usize, Number, usize)| number.width().checked_mul(*count);
    let chunk = shapes.iter().try_fold(0_usize, |sum, shape| sum.checked_add(size(shape)?));
    let Some(chunk) = chunk else { return Err("its channels announce more than any file holds".into()) };
    if chunk == 0 {
        return Ok(false);
    }
    let big_endian = flags & BIG_ENDIAN != 0;
    if flags & INTERLEAVED != 0 {
        let row: usize = shapes.iter().map(|(_, number, _)| number.width()).sum();
        budget.numbers((bytes.len() / row * shapes.len()) as u64)?;
        for row in bytes.chunks_exact(row) {
            let mut at = 0;
            for (k, number, _) in &shapes {
                objects[*k].values.push(number.value(&row[at..], big_endian));
                at += number.width();
            }
        }
        return Ok(!bytes.len().is_multiple_of(row));
    }
    for part in bytes.chunks_exact(chunk) {
        let mut at = 0;
        for (k, number, count) in &shapes {
            budget.numbers(*count as u64)?;
            budget.work(10)?;
            let end = at + number.width() * count;
            let values = part[at..end].chunks_exact(number.width()).map(|v| number.value(v, big_endian));
            objects[*k].values.extend(values);
            at = end;
        }
    }
    Ok(!bytes.len().is_multiple_of(chunk))
}

/// Converts an object to a channel. Returns `None` for the file itself and its groups.
fn channel(object: Object) -> Result<Option<Channel>, String> {
    let parts = parts(&object.path);
    let [group, name] = &parts[..] else { return Ok(None) };
    let text = |key: &str| match object.properties.get(key) {
        Some(Property::Text(text)) => Some(text.trim().to_owned()),
        _ => None,
    };
    let number = |key: &str| match object.properties.get(key) {
        Some(Property::Number(value)) => Some(*value),
        _ => None,
    };
    let mut values = object.values;
    for k in 0..number("NI_Number_Of_Scales").unwrap_or(0.0).clamp(0.0, 16.0) as usize {
        let key = |what: &str| format!("NI_Scale[{k}]_{what}");
        match text(&key("Scale_Type")).as_deref() {
            None => {}
            Some("Linear") => {
                let slope = number(&key("Linear_Slope")).unwrap_or(1.0);
                let offset = number(&key("Linear_Y_Intercept")).unwrap_or(0.0);
                values.iter_mut().for_each(|v| *v = slope * *v + offset);
            }
            Some(other) => {
                return Err(format!(
                    "'{name}' has a scaling of the kind {other}, which is not applied; save it with scaled values"
                ));
            }
        }
    }
    values.iter_mut().filter(|v| !v.is_finite()).for_each(|v| *v = f64::NAN);
    let unit = text("unit_string").or_else(|| text("NI_UnitDescription")).unwrap_or_default();
    let step = number("wf_increment").filter(|s| s.is_finite() && *s > 0.0);
    // A waveform without a start time has the start time 0, in 1904. A time before 1970 therefore counts as unknown.
    let begins = match object.properties.get("wf_start_time") {
        Some(Property::Time(seconds)) => Some(*seconds).filter(|seconds| *seconds > 0.0),
        _ => None,
    };
    Ok(Some(Channel { group: group.clone(), name: name.clone(), unit, step, begins, values }))
}

/// Splits a path such as `/'group'/'channel'` into its names. A quote within a name is doubled.
fn parts(path: &str) -> Vec<String> {
    let mut parts = Vec::new();
    let mut letters = path.chars().peekable();
    while let Some(letter) = letters.next() {
        if letter != '\'' {
            continue;
        }
        let mut part = String::new();
        while let Some(letter) = letters.next() {
            if letter == '\'' && letters.next_if_eq(&'\'').is_none() {
                break;
            }
            part.push(letter);
        }
        parts.push(part);
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_taken_apart() {
        assert_eq!(parts("/'run 1'/'driver''s force'"), ["run 1", "driver's force"]);
        assert_eq!(parts("/'run'"), ["run"]);
        assert!(parts("/").is_empty() && parts("/'open").len() == 1);
    }
}
