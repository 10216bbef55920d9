; clamp/unchanged: clamp(v, max) is some w ⇒ (w is v unchanged ⇔ √(v₁⊗v₁ ⊕ …) ≤ max)
; Each answer has to be unsat, 6 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(define-fun t6 () Float64 (fp.mul RNE x0 x0))
(define-fun t7 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t6))
(define-fun t8 () Float64 (fp.sqrt RNE t7))
(define-fun t9 () Bool (fp.leq t8 x1))
(declare-const x2 Float64)
(define-fun t47 () Float64 (fp.mul RNE x1 x1))
(define-fun t48 () Float64 (fp.add RNE t7 t47))
(define-fun t49 () Float64 (fp.sqrt RNE t48))
(define-fun t50 () Bool (fp.leq t49 x2))
(declare-const x3 Float64)
(define-fun t112 () Float64 (fp.mul RNE x2 x2))
(define-fun t113 () Float64 (fp.add RNE t48 t112))
(define-fun t114 () Float64 (fp.sqrt RNE t113))
(define-fun t115 () Bool (fp.leq t114 x3))
(push 1) ; left alone exactly within the bound
(assert t9)(assert (not t9))
(check-sat)
(pop 1)
(push 1) ; left alone exactly within the bound
(assert (not t9))(assert (not (not t9)))
(check-sat)
(pop 1)
(push 1) ; left alone exactly within the bound
(assert t50)(assert (not t50))
(check-sat)
(pop 1)
(push 1) ; left alone exactly within the bound
(assert (not t50))(assert (not (not t50)))
(check-sat)
(pop 1)
(push 1) ; left alone exactly within the bound
(assert t115)(assert (not t115))
(check-sat)
(pop 1)
(push 1) ; left alone exactly within the bound
(assert (not t115))(assert (not (not t115)))
(check-sat)
(pop 1)
