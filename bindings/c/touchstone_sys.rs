// SPDX-License-Identifier: Apache-2.0
//! Declarations of touchstone.h for Rust: the functions for a polygon. touchstone.h says what each promises.
use std::os::raw::c_char;

#[repr(C)]
pub struct Polygon {
    _private: [u8; 0],
}

#[repr(C)]
pub struct Error {
    pub status: i32,
    pub message: [c_char; 508],
}

#[repr(C)]
pub struct Ball {
    pub center: [f64; 3],
    pub radius: f64,
}

#[repr(C)]
pub struct Motion {
    pub ball: Ball,
    pub to: [f64; 3],
}

#[repr(C)]
#[derive(Default)]
pub struct Feature {
    pub index: u64,
    pub kind: i32,
    pub reserved: i32,
}

#[repr(C)]
#[derive(Default)]
pub struct Answer {
    pub plane: i32,
    pub plane_tangent: i32,
    pub foot: i32,
    pub relation: i32,
    pub nearest: Feature,
    pub point: [f64; 3],
    pub distance: f64,
    pub contact_normal: [f64; 3],
    pub depth: f64,
    pub off_plane: f64,
}

#[repr(C)]
#[derive(Default)]
pub struct FirstContact {
    pub kind: i32,
    pub momentary: i32,
    pub time: f64,
    pub feature: Feature,
    pub point: [f64; 3],
    pub contact_normal: [f64; 3],
    pub depth: f64,
}

extern "C" {
    pub fn touchstone_polygon_create(
        vertices: *const f64,
        loop_sizes: *const usize,
        loop_count: usize,
        polygon: *mut *mut Polygon,
        error: *mut Error,
    ) -> i32;
    pub fn touchstone_polygon_free(polygon: *mut Polygon);
    pub fn touchstone_polygon_answer(
        polygon: *const Polygon,
        balls: *const Ball,
        count: usize,
        answers: *mut Answer,
        error: *mut Error,
    ) -> i32;
    pub fn touchstone_polygon_first_contact(
        polygon: *const Polygon,
        motions: *const Motion,
        count: usize,
        contacts: *mut FirstContact,
        error: *mut Error,
    ) -> i32;
}
