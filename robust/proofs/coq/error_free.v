(* SPDX-License-Identifier: Apache-2.0
   Error-free transformations of double_double.h, in round to nearest, ties to even, without overflow: the rest that they
   compute is exactly what the rounding of the first operation took. From Flocq's proofs of the algorithms. *)
Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Mult_error.
From Flocq.Pff Require Import Pff2Flocq.
Open Scope R_scope.

Notation exponent := (FLT_exp (-1074) 53).
Definition format := generic_format radix2 exponent.
Definition rnd := round radix2 exponent ZnearestE.

(* Of a product with this magnitude nothing underflows. *)
Definition large (product : R) : Prop := product = 0 \/ bpow radix2 (-1074 + 2 * 53 - 1) <= Rabs product.

Local Instance precision_is_positive : Prec_gt_0 53.
Proof. unfold Prec_gt_0; lia. Qed.

Lemma ties_are_symmetric x : negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. rewrite Z.even_opp, Z.even_add; simpl; now destruct (Z.even x). Qed.

Lemma rnd_opp x : rnd (- x) = - rnd x.
Proof. apply round_N_opp_sym; exact ties_are_symmetric. Qed.

Lemma rnd_minus x y : rnd (x - y) = - rnd (y - x).
Proof. now rewrite <- rnd_opp, Ropp_minus_distr. Qed.

Lemma format_opp x : format x -> format (- x).
Proof. apply generic_format_opp. Qed.

Theorem two_sum a b : format a -> format b ->
  let sum := rnd (a + b) in let b_part := rnd (sum - a) in
  sum + rnd (rnd (a - rnd (sum - b_part)) + rnd (b - b_part)) = a + b.
Proof.
  intros Fa Fb; apply (TwoSum_correct (-1074) 53 (fun x => negb (Z.even x))); try assumption; try lia.
  exact ties_are_symmetric.
Qed.

Theorem two_difference a b : format a -> format b ->
  let difference := rnd (a - b) in let b_part := rnd (difference - a) in
  difference + rnd (rnd (a - rnd (difference - b_part)) - rnd (b + b_part)) = a - b.
Proof.
  intros Fa Fb; cbv zeta.
  replace (rnd (rnd (a - rnd (rnd (a - b) - rnd (rnd (a - b) - a))) - rnd (b + rnd (rnd (a - b) - a))))
    with (rnd (rnd (a - rnd (rnd (a + - b) - rnd (rnd (a + - b) - a))) + rnd (- b - rnd (rnd (a + - b) - a)))).
  - exact (two_sum a (- b) Fa (format_opp b Fb)).
  - replace (- b - rnd (rnd (a + - b) - a)) with (- (b + rnd (rnd (a - b) - a))) by (unfold Rminus; ring).
    rewrite rnd_opp; reflexivity.
Qed.

Theorem quick_two_sum a b : format a -> format b -> a = 0 \/ Rabs b <= Rabs a ->
  let sum := rnd (a + b) in sum + rnd (b - rnd (sum - a)) = a + b.
Proof.
  intros Fa Fb [zero | larger]; cbv zeta.
  - assert (same : rnd b = b) by (apply round_generic; [apply valid_rnd_N | exact Fb]).
    assert (nothing : rnd 0 = 0) by (apply round_0, valid_rnd_N).
    rewrite zero, Rplus_0_l, same, Rminus_0_r, same; replace (b - b) with 0 by ring; rewrite nothing; ring.
  - replace (b - rnd (rnd (a + b) - a)) with (b + rnd (a - rnd (a + b))) by (rewrite (rnd_minus (rnd (a + b)) a); ring).
    apply (Fast2Sum_correct (-1074) 53 (fun x => negb (Z.even x))); try assumption; try lia.
    exact ties_are_symmetric.
Qed.

(* The high part of a number, of 26 bits, as Veltkamp splits it. *)
Notation high a := (rnd (rnd (134217729 * a) - rnd (rnd (134217729 * a) - a))).
Notation low a := (rnd (a - high a)).

Lemma high_of_Flocq a : high a = rnd (rnd (a - rnd (a * (bpow radix2 27 + 1))) + rnd (a * (bpow radix2 27 + 1))).
Proof.
  replace (a * (bpow radix2 27 + 1)) with (134217729 * a) by (change (bpow radix2 27) with 134217728; ring).
  rewrite (rnd_minus a (rnd (134217729 * a))); f_equal; ring.
Qed.

Theorem two_product a b : format a -> format b -> large (a * b) ->
  let product := rnd (a * b) in
  product + rnd (rnd (rnd (rnd (rnd (high a * high b) - product) + rnd (high a * low b)) + rnd (low a * high b))
                 + rnd (low a * low b)) = a * b.
Proof.
  intros Fa Fb enough; cbv zeta; rewrite !high_of_Flocq.
  destruct (Dekker radix2 (-1074) 53 (fun x => negb (Z.even x)) ltac:(lia) ltac:(lia) a b Fa Fb (or_introl eq_refl))
    as [exact _].
  simpl Z.div2 in exact; change (53 - 26)%Z with 27%Z in exact.
  etransitivity; [| symmetry; exact (exact enough)].
  unfold rnd, Rminus; rewrite (Rplus_comm (- _)); reflexivity.
Qed.

Theorem fused_product a b : format a -> format b -> large (a * b) ->
  let product := rnd (a * b) in product + rnd (a * b - product) = a * b.
Proof.
  intros Fa Fb enough; cbv zeta.
  assert (error : format (rnd (a * b) - a * b)).
  { apply (mult_error_FLT radix2 (-1074) 53 ZnearestE); [exact Fa | exact Fb |]; intros some; now destruct enough. }
  replace (rnd (a * b - rnd (a * b))) with (a * b - rnd (a * b)); [ring |].
  symmetry; apply round_generic; [apply valid_rnd_N |].
  replace (a * b - rnd (a * b)) with (- (rnd (a * b) - a * b)) by ring; now apply format_opp.
Qed.

Print Assumptions two_sum.
Print Assumptions two_difference.
Print Assumptions quick_two_sum.
Print Assumptions two_product.
Print Assumptions fused_product.
