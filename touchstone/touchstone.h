// SPDX-License-Identifier: Apache-2.0
// All of Touchstone.
#pragma once

#include "answer.h"
#include "ball.h"
#include "exact.h"
#include "fast.h"
#include "filtered.h"
#include "first_contact.h"
#include "merge.h"
#include "mesh.h"
#include "motion.h"
#include "polygon.h"
#include "pose.h"
#include "posing.h"
#include "read_mesh.h"
#include "rejection.h"
#include "scene.h"
#include "scene_faces.h"
#include "thesis.h"
#include "triangle.h"
#include "validate.h"
#include "weld.h"
