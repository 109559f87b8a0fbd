(* SPDX-License-Identifier: Apache-2.0
   How often a chain of points crosses a line, modulo 2: once if one of its ends is above the line and the other is not.
   So of a chain of edges that is far from the foot only the ends matter, and a closed loop crosses an even number of
   times. *)
Require Import Arith Bool List.
Import ListNotations.

Section Chain.
Variable point : Type.
Variable above : point -> bool.

(* The last point of a chain, its first one given apart. *)
Fixpoint last (first : point) (others : list point) : point :=
  match others with [] => first | next :: rest => last next rest end.

(* The number of edges that have one end above the line and one not. *)
Fixpoint crossings (first : point) (others : list point) : nat :=
  match others with
  | [] => 0
  | next :: rest => Nat.b2n (xorb (above first) (above next)) + crossings next rest
  end.

Theorem parity_of_ends :
  forall others first, Nat.odd (crossings first others) = xorb (above first) (above (last first others)).
Proof.
  induction others as [| next rest of_rest]; intros first; cbn; [now destruct (above first) |].
  rewrite Nat.odd_add, of_rest.
  now destruct (above first), (above next), (above (last next rest)).
Qed.

Corollary closed_loop : forall first others, last first others = first -> Nat.odd (crossings first others) = false.
Proof. intros first others closed; rewrite parity_of_ends, closed; apply xorb_nilpotent. Qed.

(* Of all edges of several chains as many are crossed, modulo 2, as the chains have ends above the line. *)
Corollary ends_of_chains : forall chains,
  Nat.odd (list_sum (map (fun '(first, others) => crossings first others) chains)) =
  Nat.odd (list_sum (map (fun '(first, others) => Nat.b2n (above first) + Nat.b2n (above (last first others))) chains)).
Proof.
  induction chains as [| [first others] chains of_chains]; [reflexivity |].
  cbn [map list_sum fold_right]; fold list_sum; rewrite !Nat.odd_add, parity_of_ends.
  change (fold_right Nat.add 0) with list_sum; rewrite of_chains.
  now destruct (above first), (above (last first others)).
Qed.
End Chain.

Print Assumptions closed_loop.
Print Assumptions ends_of_chains.
