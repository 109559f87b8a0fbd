(* SPDX-License-Identifier: Apache-2.0
   The model of bounds.h, in which every claim is stated, and how a claim follows from Gappa's proof of it. *)
Require Import Reals.
From Flocq Require Import Core.
Require Import Gappa.Gappa_library.

(* numerator * 2^exponent *)
Definition dyadic (numerator exponent : Z) : R := (IZR numerator * bpow radix2 exponent)%R.

(* A number of magnitude at most `largest`. *)
Definition within (largest computed : R) : Prop := (Rabs computed <= largest)%R.

(* A number that is at most `largest` in magnitude as computed and differs from the exact one by at most `error`. *)
Definition known (largest error computed exact : R) : Prop :=
  (Rabs computed <= largest)%R /\ (Rabs (computed - exact) <= error)%R.

(* The result of an operation: the exact one, rounded with a relative error of at most `unit`. *)
Definition rounded (unit exact computed : R) : Prop :=
  exists error, (Rabs error <= unit)%R /\ computed = (exact * (1 + error))%R.

(* The same with an absolute error of at most `underflow` besides. *)
Definition underflowing (unit underflow exact computed : R) : Prop :=
  exists error rest, (Rabs error <= unit)%R /\ (Rabs rest <= underflow)%R /\ computed = (exact * (1 + error) + rest)%R.

(* Gappa's hints are identities. *)
Ltac identity :=
  unfold Float1; simpl;
  match goal with
  | |- ?divisor <> 0%R -> _ => generalize divisor; intros; field; assumption
  | |- _ => ring
  end.

(* What Gappa calls a bound of a magnitude. *)
Lemma bounded (x m : R) (i : FF) :
  (Rabs x <= m)%R -> lower i = Float2 0 0 -> m = float2R (upper i) -> BND (Rabs x) i.
Proof.
  intros small low high.
  unfold BND; rewrite low, <- high; split; [| exact small].
  unfold float2R, F2R; simpl; rewrite Rmult_0_l; apply Rabs_pos.
Qed.

(* Gappa's hypotheses from those of the claim, and a goal from its negation. *)
Ltac hypothesis :=
  match goal with
  | |- _ /\ _ => split; hypothesis
  | H : (Rabs ?x <= ?m)%R |- BND (Rabs ?x) ?i => exact (bounded x m i H eq_refl eq_refl)
  | H : within ?m ?x |- BND (Rabs ?x) ?i => exact (bounded x m i H eq_refl eq_refl)
  | |- _ \/ _ => (left; hypothesis) || (right; hypothesis)
  | H : ~ ?goal |- ~ _ => let proved := fresh in intro proved; apply H; first [exact proved | exact (proj2 proved)]
  end.
