(* SPDX-License-Identifier: Apache-2.0
   From the factors of the monomials of a value and of its permanent to the sign of the value (permanents.py). *)
Require Import Reals Lra.
Require Import Touchstone.model.
Open Scope R_scope.

Lemma one_is_dyadic : dyadic 1 0 = 1.
Proof. unfold dyadic; simpl; ring. Qed.

(* What Gappa proves of the factors of a monomial's value and of its bound, for any monomial m. *)
Lemma weighed (m shared value bound : R) :
  Rabs (shared * (value - bound)) <= dyadic 1 0 /\ dyadic 1 0 <= shared * (value + bound) ->
  m * (shared * value) - Rabs m * (shared * bound) <= m <= m * (shared * value) + Rabs m * (shared * bound).
Proof.
  rewrite one_is_dyadic; intros [below above].
  pose proof (Rle_trans _ _ _ (Rle_abs _) below).
  unfold Rabs; destruct (Rcase_abs m); nra.
Qed.

Lemma positive_factor (unit d : R) : Rabs d <= unit -> unit < 1 -> 0 < 1 + d.
Proof. unfold Rabs; destruct (Rcase_abs d); lra. Qed.

Lemma divided (a b f : R) : 0 < f -> a < b * f -> a / f < b.
Proof.
  intros positive less; apply (Rmult_lt_reg_r f); [exact positive |].
  unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r; lra.
Qed.

Lemma divided_below (a b f : R) : 0 < f -> b * f < - a -> b < - (a / f).
Proof.
  intros positive less; apply Ropp_lt_cancel; rewrite Ropp_involutive; apply divided; [exact positive | lra].
Qed.

(* Makes a number of the factor 1 + d, which is positive. *)
Ltac abstracted d within :=
  let positive := fresh in
  assert (positive := positive_factor _ d within ltac:(unfold dyadic; simpl; lra));
  rewrite ?(Rabs_pos_eq (1 + d) (Rlt_le _ _ positive));
  revert positive; generalize (1 + d); clear d within; intros d positive.

(* Both signs, from what is weighed of every monomial. *)
Ltac decided :=
  let compared := fresh in
  split; intro compared; [apply divided in compared | apply divided_below in compared];
  try assumption; unfold Rdiv, dyadic in *; simpl in *; lra.
