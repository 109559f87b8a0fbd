(* SPDX-License-Identifier: Apache-2.0
   What a pose does to lengths, and how far a ball that is moved into an object's own frame may be off (own_frame.h). *)
Require Import Reals Lra Lia Psatz.
Open Scope R_scope.

Record vector := { x : R; y : R; z : R }.
Record matrix := { row_x : vector; row_y : vector; row_z : vector }.

Definition dot (u v : vector) := x u * x v + y u * y v + z u * z v.
Definition plus (u v : vector) := {| x := x u + x v; y := y u + y v; z := z u + z v |}.
Definition minus (u v : vector) := {| x := x u - x v; y := y u - y v; z := z u - z v |}.
Definition times (a : R) (v : vector) := {| x := a * x v; y := a * y v; z := a * z v |}.
Definition norm (v : vector) := sqrt (dot v v).
Definition apply (m : matrix) (v : vector) := {| x := dot (row_x m) v; y := dot (row_y m) v; z := dot (row_z m) v |}.
Definition transposed (m : matrix) := {|
  row_x := {| x := x (row_x m); y := x (row_y m); z := x (row_z m) |};
  row_y := {| x := y (row_x m); y := y (row_y m); z := y (row_z m) |};
  row_z := {| x := z (row_x m); y := z (row_y m); z := z (row_z m) |} |}.

(* The sum of the magnitudes of the components: that of a row, and of the transposed matrix that of a column. *)
Definition sum (v : vector) := Rabs (x v) + Rabs (y v) + Rabs (z v).
Definition sums_at_most (h : R) (m : matrix) := sum (row_x m) <= h /\ sum (row_y m) <= h /\ sum (row_z m) <= h.
(* The map multiplies no length by more than a. *)
Definition stretches (a : R) (map : vector -> vector) := forall v, norm (map v) <= a * norm v.

Lemma square_not_negative (v : vector) : 0 <= dot v v.
Proof. unfold dot; nra. Qed.

Lemma norm_not_negative (v : vector) : 0 <= norm v.
Proof. apply sqrt_pos. Qed.

Lemma norm_squared (v : vector) : norm v * norm v = dot v v.
Proof. apply sqrt_sqrt, square_not_negative. Qed.

Lemma norm_at_most (v : vector) (length : R) : 0 <= length -> dot v v <= length * length -> norm v <= length.
Proof.
  intros positive at_most; unfold norm; rewrite <- (sqrt_square length positive).
  now apply sqrt_le_1_alt.
Qed.

(* Cauchy and Schwarz, from Lagrange's identity. *)
Lemma dot_at_most (u v : vector) : Rabs (dot u v) <= norm u * norm v.
Proof.
  rewrite <- (Rabs_pos_eq (norm u * norm v)) by (apply Rmult_le_pos; apply norm_not_negative).
  apply Rsqr_le_abs_0; unfold Rsqr.
  replace (norm u * norm v * (norm u * norm v)) with ((norm u * norm u) * (norm v * norm v)) by ring.
  rewrite !norm_squared.
  pose proof (Rle_0_sqr (x u * y v - y u * x v)); pose proof (Rle_0_sqr (y u * z v - z u * y v)).
  pose proof (Rle_0_sqr (z u * x v - x u * z v)); unfold Rsqr, dot in *; nra.
Qed.

Lemma norm_of_sum (u v : vector) : norm (plus u v) <= norm u + norm v.
Proof.
  pose proof (norm_not_negative u); pose proof (norm_not_negative v).
  apply norm_at_most; [lra |].
  replace (dot (plus u v) (plus u v)) with (dot u u + 2 * dot u v + dot v v) by (unfold dot, plus; simpl; ring).
  pose proof (dot_at_most u v); pose proof (Rle_abs (dot u v)).
  rewrite <- !norm_squared; lra.
Qed.

Lemma norm_of_negative (v : vector) : norm (times (-1) v) = norm v.
Proof. unfold norm, dot, times; simpl; f_equal; ring. Qed.

(* Rows and columns bound a map: Schur's test. *)
Theorem rows_and_columns (m : matrix) (h : R) :
  sums_at_most h m -> sums_at_most h (transposed m) -> stretches h (apply m).
Proof.
  intros (row1 & row2 & row3) (column1 & column2 & column3) v; unfold sum in *; simpl in *.
  assert (0 <= h) by (pose proof (Rabs_pos (x (row_x m))); pose proof (Rabs_pos (y (row_x m)));
                      pose proof (Rabs_pos (z (row_x m))); lra).
  apply norm_at_most; [apply Rmult_le_pos; [assumption | apply norm_not_negative] |].
  replace (h * norm v * (h * norm v)) with (h * h * (norm v * norm v)) by ring; rewrite norm_squared.
  (* The square of a component of the image is at most the sum of its row times the squares weighed by the row. *)
  assert (component : forall row, sum row <= h ->
            dot row v * dot row v <= h * (Rabs (x row) * (x v * x v) + Rabs (y row) * (y v * y v) + Rabs (z row) * (z v * z v))).
  { clear; intros [a b c]; unfold sum, dot; simpl; intros at_most.
    set (p := x v); set (q := y v); set (r := z v).
    assert (weighed : (a * p + b * q + c * r) * (a * p + b * q + c * r) <=
                      (Rabs a + Rabs b + Rabs c) * (Rabs a * (p * p) + Rabs b * (q * q) + Rabs c * (r * r))).
    { assert (pair : forall a b p q, 2 * (a * p) * (b * q) <= Rabs a * Rabs b * (p * p + q * q)).
      { clear; intros a b p q; pose proof (Rmult_le_pos _ _ (Rabs_pos a) (Rabs_pos b)) as positive;
        pose proof (Rmult_le_pos _ _ positive (Rle_0_sqr (p + q))); pose proof (Rmult_le_pos _ _ positive (Rle_0_sqr (p - q)));
        unfold Rsqr, Rabs in *; destruct (Rcase_abs a), (Rcase_abs b); lra. }
      assert (same : forall a, Rabs a * Rabs a = a * a).
      { clear; intros a; unfold Rabs; destruct (Rcase_abs a); ring. }
      pose proof (pair a b p q); pose proof (pair b c q r); pose proof (pair a c p r).
      replace ((Rabs a + Rabs b + Rabs c) * (Rabs a * (p * p) + Rabs b * (q * q) + Rabs c * (r * r))) with
        ((Rabs a * Rabs a) * (p * p) + (Rabs b * Rabs b) * (q * q) + (Rabs c * Rabs c) * (r * r) +
         Rabs a * Rabs b * (p * p + q * q) + Rabs b * Rabs c * (q * q + r * r) + Rabs a * Rabs c * (p * p + r * r)) by ring.
      rewrite !same; lra. }
    apply (Rle_trans _ _ _ weighed), Rmult_le_compat_r; [| exact at_most].
    pose proof (Rabs_pos a); pose proof (Rabs_pos b); pose proof (Rabs_pos c).
    pose proof (Rle_0_sqr p); pose proof (Rle_0_sqr q); pose proof (Rle_0_sqr r); unfold Rsqr in *.
    apply Rplus_le_le_0_compat; [apply Rplus_le_le_0_compat |]; now apply Rmult_le_pos. }
  pose proof (component (row_x m) row1) as of_x; pose proof (component (row_y m) row2) as of_y.
  pose proof (component (row_z m) row3) as of_z.
  apply Rle_trans with (h * ((Rabs (x (row_x m)) + Rabs (x (row_y m)) + Rabs (x (row_z m))) * (x v * x v) +
                             (Rabs (y (row_x m)) + Rabs (y (row_y m)) + Rabs (y (row_z m))) * (y v * y v) +
                             (Rabs (z (row_x m)) + Rabs (z (row_y m)) + Rabs (z (row_z m))) * (z v * z v))).
  { unfold apply, dot at 1; simpl; lra. }
  replace (h * h * dot v v) with (h * (h * (x v * x v) + h * (y v * y v) + h * (z v * z v))) by (unfold dot; ring).
  apply Rmult_le_compat_l; [assumption |].
  pose proof (Rle_0_sqr (x v)); pose proof (Rle_0_sqr (y v)); pose proof (Rle_0_sqr (z v)); unfold Rsqr in *.
  repeat apply Rplus_le_compat; apply Rmult_le_compat_r; assumption.
Qed.

(* A map that the transposed one followed by 1 / s^2 nearly undoes stretches by hardly more than s. *)
Theorem nearly_a_rotation (m : matrix) (s h : R) : 0 < s -> 0 <= h ->
  stretches h (fun v => minus (times (/ (s * s)) (apply (transposed m) (apply m v))) v) -> stretches ((1 + h) * s) (apply m).
Proof.
  intros positive not_negative near v; specialize (near v); cbv beta in near.
  pose proof (norm_not_negative v) as norm_v.
  apply norm_at_most; [apply Rmult_le_pos; [apply Rmult_le_pos; lra | exact norm_v] |].
  set (image := times (/ (s * s)) (apply (transposed m) (apply m v))) in near.
  assert (same : dot (apply m v) (apply m v) = s * s * dot image v).
  { unfold image, times, apply, transposed, dot; simpl; field; lra. }
  rewrite same.
  assert (close : dot image v <= (1 + h) * (norm v * norm v)).
  { replace (dot image v) with (dot v v + dot (minus image v) v) by (unfold dot, minus; simpl; ring).
    pose proof (dot_at_most (minus image v) v); pose proof (Rle_abs (dot (minus image v) v)).
    rewrite <- norm_squared.
    pose proof (Rmult_le_compat_r _ _ _ norm_v near); lra. }
  replace ((1 + h) * s * norm v * ((1 + h) * s * norm v)) with
    (s * s * ((1 + h) * ((1 + h) * (norm v * norm v)))) by ring.
  apply Rmult_le_compat_l; [apply Rle_0_sqr |].
  pose proof (Rmult_le_pos _ _ (Rmult_le_pos _ _ not_negative (Rplus_le_le_0_compat _ _ Rle_0_1 not_negative))
                (Rmult_le_pos _ _ norm_v norm_v)).
  lra.
Qed.

Section Frame.
(* R, A, t of a pose; a and l bound |A| and |R|, h what A R and R A are from the identity. *)
Variables (pose inverse : matrix) (t : vector) (a l h : R).
Hypothesis longer : stretches l (apply pose).
Hypothesis shorter : stretches a (apply inverse).
Hypothesis not_negative : 0 <= a /\ 0 <= l /\ 0 <= h.
Hypothesis residual : stretches h (fun v => minus (apply inverse (apply pose v)) v).
Hypothesis residual_of_centers : stretches h (fun v => minus (apply pose (apply inverse v)) v).

(* A point p that is posed to within e of R p + t, and a centre c that is seen within k of A (c - t). *)
Variables (p posed c seen : vector) (e k r reach : R).
Hypothesis rounded : norm (minus posed (plus (apply pose p) t)) <= e.
Hypothesis computed : norm (minus seen (apply inverse (minus c t))) <= k.

Ltac vectors := unfold minus, plus, times, apply, dot; simpl; f_equal; ring.

(* What a ball of radius r holds, the outer ball holds in the own frame: of radius a r + (a e + h reach) + k. *)
Theorem outer_ball_holds :
  norm p <= reach -> norm (minus posed c) <= r -> norm (minus p seen) <= a * r + (a * e + h * reach) + k.
Proof.
  intros near held.
  set (error := minus posed (plus (apply pose p) t)) in rounded.
  replace (minus p seen) with
    (plus (plus (apply inverse (plus (minus posed c) (times (-1) error)))
                (times (-1) (minus (apply inverse (apply pose p)) p)))
          (times (-1) (minus seen (apply inverse (minus c t))))) by (unfold error; vectors).
  eapply Rle_trans; [apply norm_of_sum |]; rewrite norm_of_negative.
  apply Rplus_le_compat; [| exact computed].
  eapply Rle_trans; [apply norm_of_sum |]; rewrite norm_of_negative.
  pose proof (residual p) as of_p; cbv beta in of_p.
  pose proof (shorter (plus (minus posed c) (times (-1) error))) as of_way.
  pose proof (norm_of_sum (minus posed c) (times (-1) error)) as way; rewrite norm_of_negative in way.
  destruct not_negative as (? & ? & ?).
  assert (a * norm (plus (minus posed c) (times (-1) error)) <= a * (r + e)) by (apply Rmult_le_compat_l; lra).
  assert (h * norm p <= h * reach) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(* What a ball holds in the own frame is, under the pose, not farther than l times its radius and what is lost. *)
Theorem inner_ball_is_held :
  norm (minus p seen) <= r -> norm (minus posed c) <= l * (r + k) + (h * norm (minus c t) + e).
Proof.
  intros held.
  set (error := minus posed (plus (apply pose p) t)) in rounded.
  replace (minus posed c) with
    (plus (plus (apply pose (plus (minus p seen) (minus seen (apply inverse (minus c t)))))
                (minus (apply pose (apply inverse (minus c t))) (minus c t))) error) by (unfold error; vectors).
  eapply Rle_trans; [apply norm_of_sum |].
  pose proof (norm_of_sum (apply pose (plus (minus p seen) (minus seen (apply inverse (minus c t)))))
                          (minus (apply pose (apply inverse (minus c t))) (minus c t))) as both.
  pose proof (residual_of_centers (minus c t)) as of_center; cbv beta in of_center.
  pose proof (longer (plus (minus p seen) (minus seen (apply inverse (minus c t))))) as of_way.
  pose proof (norm_of_sum (minus p seen) (minus seen (apply inverse (minus c t)))) as way.
  destruct not_negative as (? & ? & ?).
  assert (l * norm (plus (minus p seen) (minus seen (apply inverse (minus c t)))) <= l * (r + k))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(* An altitude, as any vector, is hardly shorter under the pose. *)
Theorem posed_vectors_stay_long : forall v, (1 - h) * norm v <= a * norm (apply pose v).
Proof.
  intros v.
  pose proof (residual v) as of_v; cbv beta in of_v.
  pose proof (shorter (apply pose v)).
  pose proof (norm_of_sum (apply inverse (apply pose v)) (times (-1) (minus (apply inverse (apply pose v)) v))) as both.
  rewrite norm_of_negative in both.
  replace (plus (apply inverse (apply pose v)) (times (-1) (minus (apply inverse (apply pose v)) v))) with v in both
    by (destruct v; vectors).
  lra.
Qed.
End Frame.

Print Assumptions rows_and_columns.
Print Assumptions nearly_a_rotation.
Print Assumptions outer_ball_holds.
Print Assumptions inner_ball_is_held.
Print Assumptions posed_vectors_stay_long.
