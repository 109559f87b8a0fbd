// SPDX-License-Identifier: GPL-3.0-or-later
//! Reads a case a line, in hexadecimal: the number of loops, their sizes, the bits of the vertices' coordinates, of the
//! ball's centre and radius, and of the end of its way. Prints the members of the answer and of the first contact, or the
//! status and the message of a rejection.
use std::ffi::CStr;
use std::io::{self, BufRead};
use std::ptr;

#[path = "../../../bindings/c/touchstone_sys.rs"]
mod touchstone_sys;
use touchstone_sys::*;

/// Returns what the call made, or the status and the message.
fn checked<T>(call: impl FnOnce(&mut T, &mut Error) -> i32, mut made: T) -> Result<T, String> {
    let mut error = Error { status: 0, message: [0; 508] };
    match call(&mut made, &mut error) {
        0 => Ok(made),
        status => {
            assert_eq!(status, error.status);
            let message = unsafe { CStr::from_ptr(error.message.as_ptr()) };
            Err(format!("{} {}", status, message.to_str().expect("UTF-8")))
        }
    }
}

struct OwnedPolygon(*mut Polygon);

impl OwnedPolygon {
    fn new(vertices: &[f64], loop_sizes: &[usize]) -> Result<OwnedPolygon, String> {
        let create = |polygon: &mut *mut Polygon, error: &mut Error| unsafe {
            touchstone_polygon_create(vertices.as_ptr(), loop_sizes.as_ptr(), loop_sizes.len(), polygon, error)
        };
        checked(create, ptr::null_mut()).map(OwnedPolygon)
    }

    fn answer(&self, ball: &Ball) -> Result<Answer, String> {
        checked(|answer, error| unsafe { touchstone_polygon_answer(self.0, ball, 1, answer, error) }, Answer::default())
    }

    fn first_contact(&self, motion: &Motion) -> Result<FirstContact, String> {
        checked(
            |contact, error| unsafe { touchstone_polygon_first_contact(self.0, motion, 1, contact, error) },
            FirstContact::default(),
        )
    }
}

impl Drop for OwnedPolygon {
    fn drop(&mut self) {
        unsafe { touchstone_polygon_free(self.0) }
    }
}

fn bits(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!(" {:x}", number.to_bits())).collect()
}

fn members(a: &Answer) -> String {
    format!("{} {} {} {} {} {}", a.plane, a.plane_tangent, a.foot, a.relation, a.nearest.index, a.nearest.kind)
        + &(bits(&a.point) + &bits(&[a.distance]) + &bits(&a.contact_normal) + &bits(&[a.depth, a.off_plane]))
}

fn members_of_contact(f: &FirstContact) -> String {
    format!("{} {} {} {}", f.kind, f.momentary, f.feature.index, f.feature.kind)
        + &(bits(&[f.time]) + &bits(&f.point) + &bits(&f.contact_normal) + &bits(&[f.depth]))
}

fn verdict(line: &str) -> Result<String, String> {
    let words: Vec<u64> = line.split(' ').map(|word| u64::from_str_radix(word, 16).expect("a number")).collect();
    let (sizes, coordinates) = words[1..].split_at(words[0] as usize);
    let sizes: Vec<usize> = sizes.iter().map(|size| *size as usize).collect();
    let numbers: Vec<f64> = coordinates.iter().map(|word| f64::from_bits(*word)).collect();
    let (vertices, rest) = numbers.split_at(3 * sizes.iter().sum::<usize>());
    let ball = |n: &[f64]| Ball { center: [n[0], n[1], n[2]], radius: n[3] };
    let motion = Motion { ball: ball(rest), to: [rest[4], rest[5], rest[6]] };
    let polygon = OwnedPolygon::new(vertices, &sizes)?;
    let contact = polygon.first_contact(&motion)?;
    Ok(members(&polygon.answer(&motion.ball)?) + " " + &members_of_contact(&contact))
}

fn main() {
    assert_eq!(std::mem::size_of::<Error>(), 512);
    assert_eq!(std::mem::size_of::<Answer>(), 104);
    assert_eq!(std::mem::size_of::<FirstContact>(), 88);
    for line in io::stdin().lock().lines() {
        println!("{}", verdict(&line.expect("text")).unwrap_or_else(|rejection| rejection));
    }
}
