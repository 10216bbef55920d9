; watchdog/order: ∀ last ∈ I64 ∪ {none}, s ∈ I64: advances ⇔ last = none ∨ last < s; hold_takes_effect ⇔ last = none ∨ s = 0 ∨ last ≤ s
; Each answer has to be unsat, 5 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const q0 (_ BitVec 64))
(declare-const q1 (_ BitVec 64))
(define-fun t4 () Bool (bvslt q0 q1))
(define-fun t6 () Bool (= q1 (_ bv0 64)))
(define-fun t7 () Bool (bvslt q1 q0))
(define-fun t10 () Bool (and t7 (not t6)))
(push 1) ; a HOLD takes effect
(assert (not t6))(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; a HOLD takes effect
(assert (not t6))(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; a HOLD takes effect
(assert t6)(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; advances
(assert t4)(assert (not t4))
(check-sat)
(pop 1)
(push 1) ; advances
(assert (not t4))(assert (not (not t4)))
(check-sat)
(pop 1)
