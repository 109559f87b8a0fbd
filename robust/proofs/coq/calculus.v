(* SPDX-License-Identifier: Apache-2.0
   The error calculus of error_bound.h: each of its steps, from the bounds that it is given to those that it gives. *)
Require Import ZArith QArith Qabs Qreals Reals Lra Psatz Bool List.
Open Scope R_scope.

(* Bounds of a number: what is computed lies in [low, high] and differs from the exact number by at most `error`. *)
Record bounds := { low : Q; high : Q; error : Q }.

Definition holds (b : bounds) (computed exact : R) : Prop :=
  Q2R (low b) <= computed <= Q2R (high b) /\ Rabs (computed - exact) <= Q2R (error b).

(* Arithmetic of rationals in which denominators, almost powers of two, come first in each product: that is fast. *)
Declare Scope fast_scope.
Bind Scope fast_scope with Q.
Delimit Scope fast_scope with fast.
Definition zero : Q := 0%Q.
Definition one : Q := 1%Q.
Definition half : Q := (1 # 2)%Q.
Definition ratio (numerator : Z) (odd : positive) (zeros : N) : Q := Qmake numerator (Pos.shiftl odd zeros).
Definition plus (x y : Q) : Q := Qmake (QDen y * Qnum x + QDen x * Qnum y) (Qden x * Qden y).
Definition minus (x y : Q) : Q := plus x (Qopp y).
Definition times (x y : Q) : Q := Qmult x y.
Definition over (x y : Q) : Q := Qdiv x y.
Definition is_at_most (x y : Q) : bool := (QDen y * Qnum x <=? QDen x * Qnum y)%Z.
Infix "+" := plus : fast_scope.
Infix "-" := minus : fast_scope.
Infix "*" := times : fast_scope.
Infix "/" := over : fast_scope.
Infix "<=?" := is_at_most : fast_scope.

Definition larger (x y : Q) : Q := if (x <=? y)%fast then y else x.
Definition magnitude (b : bounds) : Q := larger (Qabs (low b)) (Qabs (high b)).

(* The steps, with the numbers that they are given besides. *)
Inductive rule :=
  | Sum | Difference | Product | Square | Maximum | Magnitude
  | Division                            (* by a number that is positive, also as it would be without errors *)
  | Root                                (* of a number that is computed to be positive *)
  | Quotient (count : Q)                (* by a number that is known exactly *)
  | Rounded (unit underflow : Q)        (* the result of an operation in the model *)
  | Total (count unit underflow grown : Q)  (* of terms that are added one by one in the model *)
  | Off (by_at_most : Q).               (* a result that is known to differ by no more *)

Record step := { by_rule : rule; first : bounds; second : bounds; result : bounds }.

(* The total of n terms, each sum of which is off by relative errors d and by t; without them, the exact total. *)
Fixpoint total (terms d t : nat -> R) (n : nat) : R :=
  match n with
  | O => 0
  | S m => (total terms d t m + terms m) * (1 + d m) + t m
  end.
Definition exact_total (terms : nat -> R) : nat -> R := total terms (fun _ => 0) (fun _ => 0).

(* What a step claims. *)
Definition meaning (s : step) : Prop :=
  forall x X y Y, holds (first s) x X -> holds (second s) y Y ->
  match by_rule s with
  | Sum => holds (result s) (x + y) (X + Y)
  | Difference => holds (result s) (x - y) (X - Y)
  | Product => holds (result s) (x * y) (X * Y)
  | Square => holds (result s) (x * x) (X * X)
  | Maximum => holds (result s) (Rmax x y) (Rmax X Y)
  | Magnitude => holds (result s) (Rabs x) (Rabs X)
  | Division => holds (result s) (x / y) (X / Y)
  | Root => holds (result s) (sqrt x) (sqrt X)
  | Quotient count => holds (result s) (x / Q2R count) (X / Q2R count)
  | Rounded unit underflow => forall d t, Rabs d <= Q2R unit -> Rabs t <= Q2R underflow ->
      holds (result s) (x * (1 + d) + t) X
  | Total count unit underflow _ => forall n terms exact d t, INR n = Q2R count ->
      (forall i, holds (first s) (terms i) (exact i)) ->
      (forall i, Rabs (d i) <= Q2R unit) -> (forall i, Rabs (t i) <= Q2R underflow) ->
      holds (result s) (total terms d t n) (exact_total exact n)
  | Off by_at_most => forall t, Rabs t <= Q2R by_at_most -> holds (result s) (x + t) X
  end.

(* Whether given bounds are at least as wide as the calculus makes them. *)
Definition covers (b : bounds) (l h e : Q) : bool :=
  ((low b <=? l)%fast && (h <=? high b)%fast && (e <=? error b)%fast)%bool.

Definition corners (a b : bounds) : list Q :=
  ((low a * low b)%fast :: (low a * high b)%fast :: (high a * low b)%fast :: (high a * high b)%fast :: nil).

Definition justified (s : step) : bool :=
  let a := first s in let b := second s in let r := result s in
  match by_rule s with
  | Sum => covers r (low a + low b) (high a + high b) (error a + error b)
  | Difference => covers r (low a - high b) (high a - low b) (error a + error b)
  | Product =>
      forallb (fun corner => (low r <=? corner) && (corner <=? high r)) (corners a b) &&
      (magnitude a * error b + error a * (magnitude b + error b) <=? error r)
  | Square => covers r zero (magnitude a * magnitude a) (magnitude a * error a + error a * (magnitude a + error a))
  | Maximum => covers r (larger (low a) (low b)) (larger (high a) (high b)) (larger (error a) (error b))
  | Magnitude => covers r zero (magnitude a) (error a)
  | Division =>
      negb (low b <=? error b) &&
      forallb (fun y => (low r * y <=? low a) && (high a <=? high r * y)) (low b :: high b :: nil) &&
      (error a + magnitude r * error b <=? error r * (low b - error b))
  | Root =>
      negb (low r <=? zero) && (zero <=? high r) &&
      (low r * low r <=? low a) && (high a <=? high r * high r) && (error a <=? error r * low r)
  | Quotient count => (one <=? count) && covers r (low a / count) (high a / count) (error a / count)
  | Rounded unit underflow =>
      (unit <=? one) &&
      covers r (low a - (unit * Qabs (low a) + underflow)) (high a + (unit * Qabs (high a) + underflow))
        (error a + (unit * magnitude a + underflow))
  | Total count unit underflow grown =>
      let of_term := ((magnitude a + underflow) * grown)%fast in
      let off := (error a + underflow + unit * of_term * ((count + one) * half))%fast in
      (zero <=? unit) && (one <=? grown * (one - count * unit)) && negb (one <=? count * unit) &&
      covers r (zero - count * of_term) (count * of_term) (count * off)
  | Off by_at_most => covers r (low a - by_at_most) (high a + by_at_most) (error a + by_at_most)
  end%fast.

(* From rationals to reals. *)
Lemma real_plus (p q : Q) : Q2R (p + q)%fast = Q2R p + Q2R q.
Proof.
  rewrite <- Q2R_plus; apply Qeq_eqR; unfold plus, Qeq, Qplus; cbn [Qnum Qden]; ring.
Qed.

Lemma order (p q : Q) : (p <=? q)%fast = Qle_bool p q.
Proof. unfold is_at_most, Qle_bool; now rewrite (Z.mul_comm (QDen q)), (Z.mul_comm (QDen p)). Qed.

Lemma at_most (p q : Q) : (p <=? q)%fast = true -> Q2R p <= Q2R q.
Proof. rewrite order; intro le; apply Qle_Rle, Qle_bool_iff, le. Qed.

Lemma not_at_most (p q : Q) : negb (p <=? q)%fast = true -> Q2R q < Q2R p.
Proof.
  rewrite order; intro more; apply Qlt_Rlt, Qnot_le_lt; intro no.
  apply Qle_bool_iff in no; rewrite no in more; discriminate.
Qed.

Lemma real_abs (q : Q) : Q2R (Qabs q) = Rabs (Q2R q).
Proof.
  apply Qabs_case; intro sign; apply Qle_Rle in sign; rewrite RMicromega.Q2R_0 in sign.
  - now rewrite Rabs_pos_eq.
  - rewrite Q2R_opp; now rewrite Rabs_left1.
Qed.

Lemma larger_left (p q : Q) : Q2R p <= Q2R (larger p q).
Proof. unfold larger; destruct (p <=? q)%fast eqn:le; [now apply at_most | lra]. Qed.

Lemma larger_right (p q : Q) : Q2R q <= Q2R (larger p q).
Proof.
  unfold larger; destruct (p <=? q)%fast eqn:le; [lra |]; rewrite order in le.
  apply Qle_Rle, Qlt_le_weak, Qnot_le_lt; intro no; apply Qle_bool_iff in no; congruence.
Qed.

Lemma covered (b : bounds) (l h e : Q) (computed exact : R) :
  covers b l h e = true -> Q2R l <= computed <= Q2R h -> Rabs (computed - exact) <= Q2R e -> holds b computed exact.
Proof.
  intros wide between near; apply andb_prop in wide as [wide errors]; apply andb_prop in wide as [lows highs].
  apply at_most in errors, lows, highs; unfold holds; lra.
Qed.

Lemma within (b : bounds) (x : R) : Q2R (low b) <= x <= Q2R (high b) -> Rabs x <= Q2R (magnitude b).
Proof.
  intro between; unfold magnitude.
  pose proof (larger_left (Qabs (low b)) (Qabs (high b))) as left.
  pose proof (larger_right (Qabs (low b)) (Qabs (high b))) as right.
  rewrite real_abs in left, right; revert left right; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

Lemma small (b : bounds) (computed exact : R) : holds b computed exact -> Rabs computed <= Q2R (magnitude b).
Proof. intros [between _]; now apply within. Qed.

Lemma exact_small (b : bounds) (computed exact : R) :
  holds b computed exact -> Rabs exact <= Q2R (magnitude b) + Q2R (error b).
Proof.
  intro known; pose proof (small _ _ _ known) as in_bounds; destruct known as [_ near].
  revert in_bounds near; unfold Rabs; repeat destruct Rcase_abs; lra.
Qed.

(* A product is linear in each factor. *)
Lemma above_ends (l h m x y : R) : l <= x <= h -> m <= l * y -> m <= h * y -> m <= x * y.
Proof. intros; destruct (Rle_dec 0 y); nra. Qed.
Lemma below_ends (l h m x y : R) : l <= x <= h -> l * y <= m -> h * y <= m -> x * y <= m.
Proof. intros; destruct (Rle_dec 0 y); nra. Qed.

(* x y - X Y = x (y - Y) + (x - X) Y. *)
Lemma product_near (a b : bounds) (x X y Y : R) : holds a x X -> holds b y Y ->
  Rabs (x * y - X * Y) <= Q2R (magnitude a) * Q2R (error b) + Q2R (error a) * (Q2R (magnitude b) + Q2R (error b)).
Proof.
  intros A B; pose proof (small _ _ _ A); pose proof (exact_small _ _ _ B).
  destruct A as [_ near_a], B as [_ near_b].
  replace (x * y - X * Y) with (x * (y - Y) + (x - X) * Y) by ring.
  eapply Rle_trans; [apply Rabs_triang |]; rewrite !Rabs_mult.
  apply Rplus_le_compat; apply Rmult_le_compat; auto using Rabs_pos.
Qed.

(* q - X / Y = (q (Y - y) + (x - X)) / Y, q = x / y. *)
Lemma division_near (x X y Y l m ea eb e : R) :
  0 < l - eb -> l <= y -> Rabs (x - X) <= ea -> Rabs (y - Y) <= eb -> Rabs (x / y) <= m -> ea + m * eb <= e * (l - eb) ->
  Rabs (x / y - X / Y) <= e.
Proof.
  intros apart below near_x near_y quotient enough.
  pose proof (Rabs_pos (y - Y)); pose proof (Rabs_pos (x - X)); pose proof (Rabs_pos (x / y)).
  assert (l - eb <= Y) as least by (revert near_y; unfold Rabs; destruct Rcase_abs; lra).
  assert (0 <= e) as positive by nra.
  apply Rmult_le_reg_r with Y; [lra |]; rewrite <- (Rabs_pos_eq Y) at 2 by lra; rewrite <- Rabs_mult.
  replace ((x / y - X / Y) * Y) with ((x - X) - x / y * (y - Y)) by (field; lra).
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp, Rabs_mult.
  assert (Rabs (x / y) * Rabs (y - Y) <= m * eb) by (apply Rmult_le_compat; auto using Rabs_pos).
  nra.
Qed.

(* (sqrt x - sqrt X) sqrt x is at most x - X in magnitude, also where X is negative and its root is taken to be 0. *)
Lemma root_near (x X l ea e : R) : 0 < l <= sqrt x -> Rabs (x - X) <= ea -> ea <= e * l -> Rabs (sqrt x - sqrt X) <= e.
Proof.
  intros [positive least] near enough; pose proof (Rabs_pos (x - X)).
  assert (0 < x) by (apply Rnot_le_lt; intro no; rewrite (sqrt_neg_0 x no) in least; lra).
  pose proof (sqrt_sqrt x ltac:(lra)); pose proof (sqrt_pos X).
  assert (0 <= e) by nra.
  assert (sqrt X * sqrt X = X \/ (X < 0 /\ sqrt X = 0)) as square.
  { destruct (Rle_dec 0 X); [left; now apply sqrt_sqrt | right; split; [lra | apply sqrt_neg_0; lra]]. }
  revert near; unfold Rabs; repeat destruct Rcase_abs; destruct square as [square | [negative ->]]; nra.
Qed.

Lemma between (x m : R) : Rabs x <= m -> - m <= x <= m.
Proof. unfold Rabs; destruct Rcase_abs; lra. Qed.

(* Terms that are added one by one. *)
Lemma growth (u : R) (n : nat) : 0 <= u -> (1 + u) ^ n * (1 - INR n * u) <= 1.
Proof.
  intro positive; induction n as [| n IH]; [simpl; lra |]; rewrite S_INR; cbn [pow].
  pose proof (pow_le (1 + u) n ltac:(lra)); pose proof (pos_INR n).
  assert ((1 + u) * (1 - (INR n + 1) * u) <= 1 - INR n * u) by nra.
  nra.
Qed.

Lemma growth_at_most (u grown : R) (n : nat) :
  0 <= u -> INR n * u < 1 -> 1 <= grown * (1 - INR n * u) -> (1 + u) ^ n <= grown.
Proof.
  intros positive less enough; apply Rmult_le_reg_r with (1 - INR n * u); [lra |].
  pose proof (growth u n positive); lra.
Qed.

Section Total.
Variables (b : bounds) (terms exact d t : nat -> R) (u w : R).
Hypothesis within : forall i, holds b (terms i) (exact i).
Hypothesis relative : forall i, Rabs (d i) <= u.
Hypothesis absolutely : forall i, Rabs (t i) <= w.

Lemma total_small (n : nat) : Rabs (total terms d t n) <= INR n * ((Q2R (magnitude b) + w) * (1 + u) ^ n).
Proof.
  pose proof (Rle_trans _ _ _ (Rabs_pos _) (relative 0)); pose proof (Rle_trans _ _ _ (Rabs_pos _) (absolutely 0)).
  induction n as [| n IH]; [cbn [total INR]; rewrite Rabs_R0; lra |]; rewrite S_INR; cbn [total pow].
  pose proof (small _ _ _ (within n)) as term; pose proof (relative n); pose proof (absolutely n).
  pose proof (Rabs_pos (terms n)); set (m := Q2R (magnitude b)) in *; set (p := (1 + u) ^ n) in *.
  assert (1 <= p) by (apply pow_R1_Rle; lra).
  eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_mult.
  assert (Rabs (total terms d t n + terms n) <= INR n * ((m + w) * p) + m) as sum
    by (eapply Rle_trans; [apply Rabs_triang | lra]).
  assert (Rabs (1 + d n) <= 1 + u) as factor by (eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_R1; lra).
  pose proof (Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) sum factor).
  assert (0 <= m) by lra; assert (0 <= (m + w) * (p - 1)) as more by (apply Rmult_le_pos; lra).
  pose proof (Rmult_le_pos u _ ltac:(lra) more).
  nra.
Qed.

Lemma total_near (grown : R) (n : nat) : (1 + u) ^ n <= grown ->
  Rabs (total terms d t n - exact_total exact n) <=
  INR n * (Q2R (error b) + w + u * ((Q2R (magnitude b) + w) * grown) * ((INR n + 1) / 2)).
Proof.
  pose proof (Rle_trans _ _ _ (Rabs_pos _) (relative 0)); pose proof (Rle_trans _ _ _ (Rabs_pos _) (absolutely 0)).
  unfold exact_total; induction n as [| n IH]; intro grows; [cbn [total INR]; rewrite Rminus_0_r, Rabs_R0; lra |].
  assert (1 <= (1 + u) ^ n) by (apply pow_R1_Rle; lra).
  assert ((1 + u) ^ n <= grown) as less by (cbn [pow] in grows; nra).
  specialize (IH less); rewrite S_INR; cbn [total]; rewrite Rplus_0_r, Rplus_0_r, Rmult_1_r.
  pose proof (within n) as [_ near]; pose proof (small _ _ _ (within n)) as term.
  pose proof (relative n); pose proof (absolutely n); pose proof (total_small n); pose proof (pos_INR n).
  pose proof (Rabs_pos (terms n)); set (m := Q2R (magnitude b)) in *; set (s := total terms d t n) in *.
  set (S := total exact (fun _ => 0) (fun _ => 0) n) in *; set (e := Q2R (error b)) in *; set (p := (1 + u) ^ n) in *.
  replace ((s + terms n) * (1 + d n) + t n - (S + exact n))
    with ((s - S) + ((terms n - exact n) + (d n * (s + terms n) + t n))) by ring.
  assert (0 <= (m + w) * grown) by (apply Rmult_le_pos; lra).
  assert (Rabs (s + terms n) <= (INR n + 1) * ((m + w) * grown)) as sum.
  { eapply Rle_trans; [apply Rabs_triang |].
    assert ((m + w) * p <= (m + w) * grown) by (apply Rmult_le_compat_l; lra).
    assert (INR n * ((m + w) * p) <= INR n * ((m + w) * grown)) by (apply Rmult_le_compat_l; lra).
    assert (m <= (m + w) * grown) by nra.
    lra. }
  assert (Rabs (d n * (s + terms n)) <= u * ((INR n + 1) * ((m + w) * grown)))
    by (rewrite Rabs_mult; apply Rmult_le_compat; auto using Rabs_pos).
  pose proof (Rabs_triang (s - S) ((terms n - exact n) + (d n * (s + terms n) + t n))).
  pose proof (Rabs_triang (terms n - exact n) (d n * (s + terms n) + t n)).
  pose proof (Rabs_triang (d n * (s + terms n)) (t n)).
  assert (0 <= INR n * (u * ((m + w) * grown))) by (repeat apply Rmult_le_pos; lra).
  nra.
Qed.
End Total.

Ltac real := unfold zero, minus, times in *; repeat (rewrite ?real_plus, ?Q2R_mult, ?Q2R_opp, ?real_abs, ?RMicromega.Q2R_0 in *).
Ltac parts := repeat match goal with H : (_ && _)%bool = true |- _ => apply andb_prop in H as [? ?] end.
Ltac absolute := unfold Rabs, Rmax in *; repeat (destruct Rcase_abs || destruct Rle_dec); lra.

Theorem sound : forall s, justified s = true -> meaning s.
Proof.
  intros [[] a b r]; unfold justified, meaning; cbn [by_rule first second result]; intros just x X y Y A B.
  - apply (covered _ _ _ _ _ _ just); destruct A as [? near_a], B as [? near_b]; real; [lra |].
    replace (x + y - (X + Y)) with ((x - X) + (y - Y)) by ring.
    eapply Rle_trans; [apply Rabs_triang | lra].
  - apply (covered _ _ _ _ _ _ just); destruct A as [? near_a], B as [? near_b]; real; [lra |].
    replace (x - y - (X - Y)) with ((x - X) + - (y - Y)) by ring.
    eapply Rle_trans; [apply Rabs_triang |]; rewrite Rabs_Ropp; lra.
  - parts. split.
    + destruct A as [in_a _], B as [in_b _].
      cbn [corners forallb] in H; parts.
      repeat match goal with H : (_ <=? _)%fast = true |- _ => apply at_most in H end; real.
      split; [apply (above_ends _ _ _ _ _ in_a) | apply (below_ends _ _ _ _ _ in_a)]; rewrite Rmult_comm.
      1, 2: apply (above_ends _ _ _ _ _ in_b); rewrite Rmult_comm; assumption.
      1, 2: apply (below_ends _ _ _ _ _ in_b); rewrite Rmult_comm; assumption.
    + apply at_most in H0; real; eapply Rle_trans; [apply (product_near a b); eassumption | assumption].
  - apply (covered _ _ _ _ _ _ just); real.
    + pose proof (small _ _ _ A); pose proof (Rabs_pos x).
      assert (x * x = Rabs x * Rabs x) as -> by (unfold Rabs; destruct Rcase_abs; ring).
      nra.
    + apply product_near; assumption.
  - apply (covered _ _ _ _ _ _ just).
    + destruct A as [in_a _], B as [in_b _].
      pose proof (larger_left (low a) (low b)); pose proof (larger_right (low a) (low b)).
      pose proof (larger_left (high a) (high b)); pose proof (larger_right (high a) (high b)).
      unfold larger at 1; destruct (low a <=? low b)%fast; absolute.
    + pose proof (larger_left (error a) (error b)); pose proof (larger_right (error a) (error b)).
      destruct A as [_ near_a], B as [_ near_b]; absolute.
  - apply (covered _ _ _ _ _ _ just).
    + pose proof (small _ _ _ A); pose proof (Rabs_pos x); real; lra.
    + destruct A as [_ near_a]; absolute.
  - parts; apply not_at_most in H; cbn [forallb] in *; parts.
    repeat match goal with H : (_ <=? _)%fast = true |- _ => apply at_most in H end; real.
    destruct A as [in_a near_a], B as [in_b near_b]; pose proof (Rabs_pos (y - Y)).
    assert (Q2R (low r) <= x / y <= Q2R (high r)) as in_r.
    { split; apply Rmult_le_reg_r with y; try lra; replace (x / y * y) with x by (field; lra); rewrite Rmult_comm.
      - apply Rle_trans with (Q2R (low a)); [apply (below_ends _ _ _ _ _ in_b); lra | lra].
      - apply Rle_trans with (Q2R (high a)); [lra | apply (above_ends _ _ _ _ _ in_b); lra]. }
    split; [assumption |].
    apply (division_near _ _ _ _ (Q2R (low b)) (Q2R (magnitude r)) (Q2R (error a)) (Q2R (error b))); try lra.
    now apply within.
  - parts; apply not_at_most in H.
    repeat match goal with H : (_ <=? _)%fast = true |- _ => apply at_most in H end; real.
    destruct A as [in_a near_a].
    assert (Q2R (low r) <= sqrt x) by (rewrite <- (sqrt_square (Q2R (low r))) by lra; apply sqrt_le_1_alt; lra).
    split; [split; [assumption |] |].
    + rewrite <- (sqrt_square (Q2R (high r))) by assumption; apply sqrt_le_1_alt; lra.
    + apply (root_near _ _ (Q2R (low r)) (Q2R (error a))); lra.
  - parts. apply at_most in H.
    assert (0 < Q2R count) by (revert H; unfold Q2R at 1; cbn; lra).
    assert (~ (count == 0)%Q) as nonzero by (intro zero; apply Qeq_eqR in zero; rewrite RMicromega.Q2R_0 in zero; lra).
    assert (0 < / Q2R count) by now apply Rinv_0_lt_compat.
    apply (covered _ _ _ _ _ _ H0); destruct A as [in_a near_a]; unfold over; rewrite ?Q2R_div by assumption; unfold Rdiv.
    + split; apply Rmult_le_compat_r; lra.
    + replace (x * / Q2R count - X * / Q2R count) with ((x - X) * / Q2R count) by ring.
      rewrite Rabs_mult, (Rabs_pos_eq (/ _)) by lra; apply Rmult_le_compat_r; lra.
  - intros d t small_d small_t; parts; apply at_most in H; replace (Q2R one) with 1 in H by (unfold Q2R; cbn; lra).
    apply (covered _ _ _ _ _ _ H0); pose proof (small _ _ _ A) as small_x; destruct A as [in_a near_a]; real.
    + assert (forall end_, (1 + d) * end_ - end_ = d * end_) by (intros; ring).
      assert (forall end_, - (Q2R unit * Rabs end_) <= d * end_ <= Q2R unit * Rabs end_) as moved.
      { intro end_; apply between; rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos | assumption]. }
      pose proof (moved (Q2R (low a))); pose proof (moved (Q2R (high a))).
      assert (0 <= 1 + d) as grows by absolute.
      pose proof (Rmult_le_compat_r _ _ _ grows (proj1 in_a)); pose proof (Rmult_le_compat_r _ _ _ grows (proj2 in_a)).
      apply between in small_t; lra.
    + replace (x * (1 + d) + t - X) with ((x - X) + (x * d + t)) by ring.
      eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat; [assumption |].
      eapply Rle_trans; [apply Rabs_triang |]; apply Rplus_le_compat; [| assumption].
      rewrite Rabs_mult, Rmult_comm; apply Rmult_le_compat; auto using Rabs_pos.
  - intros n terms exact d t counted within relative absolutely; parts.
    match goal with H : negb _ = true |- _ => apply not_at_most in H end.
    repeat match goal with H : (_ <=? _)%fast = true |- _ => apply at_most in H end.
    match goal with H : covers _ _ _ _ = true |- _ => apply (covered _ _ _ _ _ _ H) end.
    all: assert (Q2R one = 1 /\ Q2R half = / 2) as [unity halved] by (unfold Q2R; cbn; lra).
    all: real; rewrite unity, <- counted in *; rewrite ?halved.
    all: assert ((1 + Q2R unit) ^ n <= Q2R grown) as grows by (apply growth_at_most; lra).
    + pose proof (total_small _ _ _ _ _ _ _ within relative absolutely n) as at_most_terms.
      pose proof (Rle_trans _ _ _ (Rabs_pos _) (small _ _ _ (within 0%nat))).
      pose proof (Rle_trans _ _ _ (Rabs_pos _) (absolutely 0%nat)).
      rewrite Rplus_0_l; apply between; eapply Rle_trans; [exact at_most_terms |].
      apply Rmult_le_compat_l; [apply pos_INR | apply Rmult_le_compat_l; lra].
    + eapply Rle_trans; [apply (total_near _ _ _ _ _ _ _ within relative absolutely _ _ grows) | lra].
  - intros t small_t; apply (covered _ _ _ _ _ _ just); destruct A as [in_a near_a]; real.
    + apply between in small_t; lra.
    + replace (x + t - X) with ((x - X) + t) by ring.
      eapply Rle_trans; [apply Rabs_triang | lra].
Qed.

Theorem all_sound : forall steps, forallb justified steps = true -> forall s, In s steps -> meaning s.
Proof. intros steps just s within; apply sound; revert s within; now apply forallb_forall. Qed.

Print Assumptions all_sound.
