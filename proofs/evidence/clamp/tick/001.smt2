; clamp/tick: limit_tick(channels, limit) is ok ⇔ fin(channels) ∧ (enabled ⇒ velocity is named, 3 wide, in m/s); and then ∀ c in m/s: ‖c‖ ≤ max
; Each answer has to be unsat, 168 of them. A question is a check that fails where the kernel has taken
; these decisions. x… are the doubles in the order in which the harness draws them, q… the seqs.
(set-logic QF_BVFP)
(declare-const x0 Float64)
(declare-const x1 Float64)
(declare-const x2 Float64)
(declare-const x3 Float64)
(declare-const x4 Float64)
(define-fun t5 () Bool (not (or (fp.isNaN x1) (fp.isInfinite x1))))
(define-fun t6 () Bool (not (or (fp.isNaN x2) (fp.isInfinite x2))))
(define-fun t7 () Bool (not (or (fp.isNaN x4) (fp.isInfinite x4))))
(define-fun t9 () Bool (and t5 t6))
(define-fun t10 () Bool (and t7 t9))
(define-fun t13 () Bool (not (or (fp.isNaN x3) (fp.isInfinite x3))))
(define-fun t14 () Bool (and t9 t13))
(define-fun t15 () Bool (and t7 t14))
(define-fun t18 () Bool (not (or (fp.isNaN x0) (fp.isInfinite x0))))
(define-fun t19 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t20 () Float64 (fp.mul RNE x4 x4))
(define-fun t21 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t20))
(define-fun t22 () Float64 (fp.sqrt RNE t21))
(define-fun t23 () Bool (fp.leq t22 x0))
(define-fun t24 () Bool (and t18 t19))
(define-fun t25 () Bool (not (or (fp.isNaN t22) (fp.isInfinite t22))))
(define-fun t27 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110111)))
(define-fun t28 () Float64 (fp.div RNE t27 t22))
(define-fun t29 () Float64 (fp.mul RNE x4 t28))
(define-fun t30 () Float64 (fp.mul RNE t29 t29))
(define-fun t31 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t30))
(define-fun t32 () Float64 (fp.sqrt RNE t31))
(define-fun t33 () Bool (fp.leq t32 x0))
(define-fun t34 () Float64 (fp.abs x4))
(define-fun t35 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t34))
(define-fun t36 () Float64 (fp.div RNE x4 t34))
(define-fun t37 () Float64 (fp.mul RNE t36 t36))
(define-fun t38 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t37))
(define-fun t39 () Float64 (fp.sqrt RNE t38))
(define-fun t40 () Float64 (fp.div RNE t27 t39))
(define-fun t41 () Float64 (fp.mul RNE t36 t40))
(define-fun t42 () Float64 (fp.mul RNE t41 t41))
(define-fun t43 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t42))
(define-fun t44 () Float64 (fp.sqrt RNE t43))
(define-fun t45 () Bool (fp.leq t44 x0))
(define-fun t46 () Float64 (fp.div RNE x4 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t47 () Float64 (fp.mul RNE t46 t46))
(define-fun t48 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t47))
(define-fun t49 () Float64 (fp.sqrt RNE t48))
(define-fun t50 () Float64 (fp.div RNE t27 t49))
(define-fun t51 () Float64 (fp.mul RNE t46 t50))
(define-fun t52 () Float64 (fp.mul RNE t51 t51))
(define-fun t53 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t52))
(define-fun t54 () Float64 (fp.sqrt RNE t53))
(define-fun t55 () Bool (fp.leq t54 x0))
(define-fun t56 () Float64 (fp.mul RNE x1 x1))
(define-fun t57 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t56))
(define-fun t58 () Float64 (fp.mul RNE x2 x2))
(define-fun t59 () Float64 (fp.add RNE t57 t58))
(define-fun t74 () Float64 (fp.abs x1))
(define-fun t75 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t74))
(define-fun t76 () Float64 (fp.abs x2))
(define-fun t77 () Bool (fp.lt t74 t76))
(define-fun t78 () Float64 (fp.div RNE x1 t76))
(define-fun t79 () Float64 (fp.div RNE x2 t76))
(define-fun t80 () Float64 (fp.mul RNE t78 t78))
(define-fun t81 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t80))
(define-fun t82 () Float64 (fp.mul RNE t79 t79))
(define-fun t83 () Float64 (fp.add RNE t81 t82))
(define-fun t94 () Float64 (fp.div RNE x1 t74))
(define-fun t95 () Float64 (fp.div RNE x2 t74))
(define-fun t96 () Float64 (fp.mul RNE t94 t94))
(define-fun t97 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t96))
(define-fun t98 () Float64 (fp.mul RNE t95 t95))
(define-fun t99 () Float64 (fp.add RNE t97 t98))
(define-fun t110 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t76))
(define-fun t111 () Float64 (fp.div RNE x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t112 () Float64 (fp.div RNE x2 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t113 () Float64 (fp.mul RNE t111 t111))
(define-fun t114 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t113))
(define-fun t115 () Float64 (fp.mul RNE t112 t112))
(define-fun t116 () Float64 (fp.add RNE t114 t115))
(define-fun t127 () Float64 (fp.mul RNE x3 x3))
(define-fun t128 () Float64 (fp.add RNE t59 t127))
(define-fun t129 () Float64 (fp.sqrt RNE t128))
(define-fun t130 () Bool (fp.leq t129 x0))
(define-fun t131 () Bool (not (or (fp.isNaN t129) (fp.isInfinite t129))))
(define-fun t133 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110101)))
(define-fun t134 () Float64 (fp.div RNE t133 t129))
(define-fun t135 () Float64 (fp.mul RNE x1 t134))
(define-fun t136 () Float64 (fp.mul RNE x2 t134))
(define-fun t137 () Float64 (fp.mul RNE x3 t134))
(define-fun t138 () Float64 (fp.mul RNE t135 t135))
(define-fun t139 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t138))
(define-fun t140 () Float64 (fp.mul RNE t136 t136))
(define-fun t141 () Float64 (fp.add RNE t139 t140))
(define-fun t142 () Float64 (fp.mul RNE t137 t137))
(define-fun t143 () Float64 (fp.add RNE t141 t142))
(define-fun t144 () Float64 (fp.sqrt RNE t143))
(define-fun t145 () Bool (fp.leq t144 x0))
(define-fun t146 () Float64 (fp.abs x3))
(define-fun t147 () Bool (fp.lt t76 t146))
(define-fun t148 () Float64 (fp.div RNE x1 t146))
(define-fun t149 () Float64 (fp.div RNE x2 t146))
(define-fun t150 () Float64 (fp.div RNE x3 t146))
(define-fun t151 () Float64 (fp.mul RNE t148 t148))
(define-fun t152 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t151))
(define-fun t153 () Float64 (fp.mul RNE t149 t149))
(define-fun t154 () Float64 (fp.add RNE t152 t153))
(define-fun t155 () Float64 (fp.mul RNE t150 t150))
(define-fun t156 () Float64 (fp.add RNE t154 t155))
(define-fun t157 () Float64 (fp.sqrt RNE t156))
(define-fun t158 () Float64 (fp.div RNE t133 t157))
(define-fun t159 () Float64 (fp.mul RNE t148 t158))
(define-fun t160 () Float64 (fp.mul RNE t149 t158))
(define-fun t161 () Float64 (fp.mul RNE t150 t158))
(define-fun t162 () Float64 (fp.mul RNE t159 t159))
(define-fun t163 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t162))
(define-fun t164 () Float64 (fp.mul RNE t160 t160))
(define-fun t165 () Float64 (fp.add RNE t163 t164))
(define-fun t166 () Float64 (fp.mul RNE t161 t161))
(define-fun t167 () Float64 (fp.add RNE t165 t166))
(define-fun t168 () Float64 (fp.sqrt RNE t167))
(define-fun t169 () Bool (fp.leq t168 x0))
(define-fun t170 () Float64 (fp.div RNE x3 t76))
(define-fun t171 () Float64 (fp.mul RNE t170 t170))
(define-fun t172 () Float64 (fp.add RNE t83 t171))
(define-fun t173 () Float64 (fp.sqrt RNE t172))
(define-fun t174 () Float64 (fp.div RNE t133 t173))
(define-fun t175 () Float64 (fp.mul RNE t78 t174))
(define-fun t176 () Float64 (fp.mul RNE t79 t174))
(define-fun t177 () Float64 (fp.mul RNE t170 t174))
(define-fun t178 () Float64 (fp.mul RNE t175 t175))
(define-fun t179 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t178))
(define-fun t180 () Float64 (fp.mul RNE t176 t176))
(define-fun t181 () Float64 (fp.add RNE t179 t180))
(define-fun t182 () Float64 (fp.mul RNE t177 t177))
(define-fun t183 () Float64 (fp.add RNE t181 t182))
(define-fun t184 () Float64 (fp.sqrt RNE t183))
(define-fun t185 () Bool (fp.leq t184 x0))
(define-fun t186 () Bool (fp.lt t74 t146))
(define-fun t187 () Float64 (fp.div RNE x3 t74))
(define-fun t188 () Float64 (fp.mul RNE t187 t187))
(define-fun t189 () Float64 (fp.add RNE t99 t188))
(define-fun t190 () Float64 (fp.sqrt RNE t189))
(define-fun t191 () Float64 (fp.div RNE t133 t190))
(define-fun t192 () Float64 (fp.mul RNE t94 t191))
(define-fun t193 () Float64 (fp.mul RNE t95 t191))
(define-fun t194 () Float64 (fp.mul RNE t187 t191))
(define-fun t195 () Float64 (fp.mul RNE t192 t192))
(define-fun t196 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t195))
(define-fun t197 () Float64 (fp.mul RNE t193 t193))
(define-fun t198 () Float64 (fp.add RNE t196 t197))
(define-fun t199 () Float64 (fp.mul RNE t194 t194))
(define-fun t200 () Float64 (fp.add RNE t198 t199))
(define-fun t201 () Float64 (fp.sqrt RNE t200))
(define-fun t202 () Bool (fp.leq t201 x0))
(define-fun t203 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t146))
(define-fun t204 () Float64 (fp.div RNE x3 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t205 () Float64 (fp.mul RNE t204 t204))
(define-fun t206 () Float64 (fp.add RNE t116 t205))
(define-fun t207 () Float64 (fp.sqrt RNE t206))
(define-fun t208 () Float64 (fp.div RNE t133 t207))
(define-fun t209 () Float64 (fp.mul RNE t111 t208))
(define-fun t210 () Float64 (fp.mul RNE t112 t208))
(define-fun t211 () Float64 (fp.mul RNE t204 t208))
(define-fun t212 () Float64 (fp.mul RNE t209 t209))
(define-fun t213 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t212))
(define-fun t214 () Float64 (fp.mul RNE t210 t210))
(define-fun t215 () Float64 (fp.add RNE t213 t214))
(define-fun t216 () Float64 (fp.mul RNE t211 t211))
(define-fun t217 () Float64 (fp.add RNE t215 t216))
(define-fun t218 () Float64 (fp.sqrt RNE t217))
(define-fun t219 () Bool (fp.leq t218 x0))
(define-fun t220 () Bool (and t15 t24))
(define-fun t223 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t225 () Bool (and t23 t130))
(push 1) ; every channel in m/s is within the limit
(assert t23)(assert (not t23))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t33)(assert (not t33))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t45)(assert (not t45))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t55)(assert (not t55))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t130)(assert (not t130))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t145)(assert (not t145))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t169)(assert (not t169))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t185)(assert (not t185))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t202)(assert (not t202))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t219)(assert (not t219))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert (not t219))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert t219)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert t219)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert (not t203))(assert t219)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert (not t169))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert (not t110))(assert t203)(assert t169)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert (not t185))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert t185)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert t185)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert (not t147))(assert t185)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert (not t169))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert (not t75))(assert t110)(assert t147)(assert t169)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert (not t202))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert t202)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert t202)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert (not t186))(assert t202)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert (not t169))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert (not t77))(assert t186)(assert t169)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert (not t185))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert t185)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert t185)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert (not t147))(assert t185)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert (not t169))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert t169)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert (not t131))(assert t75)(assert t77)(assert t147)(assert t169)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert t55)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert t45)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert (not t23))(assert t25)(assert t33)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert (not t145))(assert t7)(assert t23)(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert t145)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert t145)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t130))(assert t131)(assert t145)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert t130)(assert t7)(assert (not t23))(assert (not t25))(assert (not t35))(assert (not t55))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert t130)(assert t7)(assert (not t23))(assert (not t25))(assert t35)(assert (not t45))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert t130)(assert t7)(assert (not t23))(assert t25)(assert (not t33))(assert (not t223))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert (not t5))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert t5)(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite only when so
(assert t5)(assert t6)(assert (not t13))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t130)(assert (not t130))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t130))(assert (not (not t130)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t23)(assert t130)(assert (not t225))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t23))(assert (not t130))(assert (not (not t225)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t23))(assert t130)(assert (not (not t225)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t23)(assert (not t130))(assert (not (not t225)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t13)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t13))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t7)(assert t13)(assert t18)(assert t19)(assert (not t220))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert (not (not t220)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert (not t6))(assert (not (not t220)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert t18)(assert t19)(assert (not (not t220)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t13))(assert (not (not t220)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t13)(assert (not t18))(assert (not (not t220)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t13)(assert t18)(assert (not t19))(assert (not (not t220)))
(check-sat)
(pop 1)
