; clamp/tick: limit_tick(channels, limit) is ok ⇔ ¬faulty ∧ fin(channels) ∧ (enabled ⇒ velocity is named, 3 wide, in m/s); and then ∀ c in m/s: ‖c‖ ≤ max
; Each answer has to be unsat, 189 of them. A question is a check that fails where the kernel has taken
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
(define-fun t26 () Bool (and (not t10) t24))
(define-fun t28 () Bool (not (or (fp.isNaN t22) (fp.isInfinite t22))))
(define-fun t30 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110111)))
(define-fun t31 () Float64 (fp.div RNE t30 t22))
(define-fun t32 () Float64 (fp.mul RNE x4 t31))
(define-fun t33 () Float64 (fp.mul RNE t32 t32))
(define-fun t34 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t33))
(define-fun t35 () Float64 (fp.sqrt RNE t34))
(define-fun t36 () Bool (fp.leq t35 x0))
(define-fun t37 () Float64 (fp.abs x4))
(define-fun t38 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t37))
(define-fun t39 () Float64 (fp.div RNE x4 t37))
(define-fun t40 () Float64 (fp.mul RNE t39 t39))
(define-fun t41 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t40))
(define-fun t42 () Float64 (fp.sqrt RNE t41))
(define-fun t43 () Float64 (fp.div RNE t30 t42))
(define-fun t44 () Float64 (fp.mul RNE t39 t43))
(define-fun t45 () Float64 (fp.mul RNE t44 t44))
(define-fun t46 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t45))
(define-fun t47 () Float64 (fp.sqrt RNE t46))
(define-fun t48 () Bool (fp.leq t47 x0))
(define-fun t49 () Float64 (fp.div RNE x4 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t50 () Float64 (fp.mul RNE t49 t49))
(define-fun t51 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t50))
(define-fun t52 () Float64 (fp.sqrt RNE t51))
(define-fun t53 () Float64 (fp.div RNE t30 t52))
(define-fun t54 () Float64 (fp.mul RNE t49 t53))
(define-fun t55 () Float64 (fp.mul RNE t54 t54))
(define-fun t56 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t55))
(define-fun t57 () Float64 (fp.sqrt RNE t56))
(define-fun t58 () Bool (fp.leq t57 x0))
(define-fun t59 () Bool (and t10 t24))
(define-fun t61 () Float64 (fp.mul RNE x1 x1))
(define-fun t62 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t61))
(define-fun t63 () Float64 (fp.mul RNE x2 x2))
(define-fun t64 () Float64 (fp.add RNE t62 t63))
(define-fun t79 () Float64 (fp.abs x1))
(define-fun t80 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t79))
(define-fun t81 () Float64 (fp.abs x2))
(define-fun t82 () Bool (fp.lt t79 t81))
(define-fun t83 () Float64 (fp.div RNE x1 t81))
(define-fun t84 () Float64 (fp.div RNE x2 t81))
(define-fun t85 () Float64 (fp.mul RNE t83 t83))
(define-fun t86 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t85))
(define-fun t87 () Float64 (fp.mul RNE t84 t84))
(define-fun t88 () Float64 (fp.add RNE t86 t87))
(define-fun t99 () Float64 (fp.div RNE x1 t79))
(define-fun t100 () Float64 (fp.div RNE x2 t79))
(define-fun t101 () Float64 (fp.mul RNE t99 t99))
(define-fun t102 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t101))
(define-fun t103 () Float64 (fp.mul RNE t100 t100))
(define-fun t104 () Float64 (fp.add RNE t102 t103))
(define-fun t115 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t81))
(define-fun t116 () Float64 (fp.div RNE x1 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t117 () Float64 (fp.div RNE x2 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t118 () Float64 (fp.mul RNE t116 t116))
(define-fun t119 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t118))
(define-fun t120 () Float64 (fp.mul RNE t117 t117))
(define-fun t121 () Float64 (fp.add RNE t119 t120))
(define-fun t132 () Bool (and (not t15) t24))
(define-fun t134 () Bool (and t15 t24))
(define-fun t136 () Float64 (fp.mul RNE x3 x3))
(define-fun t137 () Float64 (fp.add RNE t64 t136))
(define-fun t138 () Float64 (fp.sqrt RNE t137))
(define-fun t139 () Bool (fp.leq t138 x0))
(define-fun t140 () Bool (not (or (fp.isNaN t138) (fp.isInfinite t138))))
(define-fun t142 () Float64 (fp.mul RNE x0 (fp #b0 #b01111111110 #b1111111111111111111111111111111111111111111111110101)))
(define-fun t143 () Float64 (fp.div RNE t142 t138))
(define-fun t144 () Float64 (fp.mul RNE x1 t143))
(define-fun t145 () Float64 (fp.mul RNE x2 t143))
(define-fun t146 () Float64 (fp.mul RNE x3 t143))
(define-fun t147 () Float64 (fp.mul RNE t144 t144))
(define-fun t148 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t147))
(define-fun t149 () Float64 (fp.mul RNE t145 t145))
(define-fun t150 () Float64 (fp.add RNE t148 t149))
(define-fun t151 () Float64 (fp.mul RNE t146 t146))
(define-fun t152 () Float64 (fp.add RNE t150 t151))
(define-fun t153 () Float64 (fp.sqrt RNE t152))
(define-fun t154 () Bool (fp.leq t153 x0))
(define-fun t155 () Float64 (fp.abs x3))
(define-fun t156 () Bool (fp.lt t81 t155))
(define-fun t157 () Float64 (fp.div RNE x1 t155))
(define-fun t158 () Float64 (fp.div RNE x2 t155))
(define-fun t159 () Float64 (fp.div RNE x3 t155))
(define-fun t160 () Float64 (fp.mul RNE t157 t157))
(define-fun t161 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t160))
(define-fun t162 () Float64 (fp.mul RNE t158 t158))
(define-fun t163 () Float64 (fp.add RNE t161 t162))
(define-fun t164 () Float64 (fp.mul RNE t159 t159))
(define-fun t165 () Float64 (fp.add RNE t163 t164))
(define-fun t166 () Float64 (fp.sqrt RNE t165))
(define-fun t167 () Float64 (fp.div RNE t142 t166))
(define-fun t168 () Float64 (fp.mul RNE t157 t167))
(define-fun t169 () Float64 (fp.mul RNE t158 t167))
(define-fun t170 () Float64 (fp.mul RNE t159 t167))
(define-fun t171 () Float64 (fp.mul RNE t168 t168))
(define-fun t172 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t171))
(define-fun t173 () Float64 (fp.mul RNE t169 t169))
(define-fun t174 () Float64 (fp.add RNE t172 t173))
(define-fun t175 () Float64 (fp.mul RNE t170 t170))
(define-fun t176 () Float64 (fp.add RNE t174 t175))
(define-fun t177 () Float64 (fp.sqrt RNE t176))
(define-fun t178 () Bool (fp.leq t177 x0))
(define-fun t179 () Float64 (fp.div RNE x3 t81))
(define-fun t180 () Float64 (fp.mul RNE t179 t179))
(define-fun t181 () Float64 (fp.add RNE t88 t180))
(define-fun t182 () Float64 (fp.sqrt RNE t181))
(define-fun t183 () Float64 (fp.div RNE t142 t182))
(define-fun t184 () Float64 (fp.mul RNE t83 t183))
(define-fun t185 () Float64 (fp.mul RNE t84 t183))
(define-fun t186 () Float64 (fp.mul RNE t179 t183))
(define-fun t187 () Float64 (fp.mul RNE t184 t184))
(define-fun t188 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t187))
(define-fun t189 () Float64 (fp.mul RNE t185 t185))
(define-fun t190 () Float64 (fp.add RNE t188 t189))
(define-fun t191 () Float64 (fp.mul RNE t186 t186))
(define-fun t192 () Float64 (fp.add RNE t190 t191))
(define-fun t193 () Float64 (fp.sqrt RNE t192))
(define-fun t194 () Bool (fp.leq t193 x0))
(define-fun t195 () Bool (fp.lt t79 t155))
(define-fun t196 () Float64 (fp.div RNE x3 t79))
(define-fun t197 () Float64 (fp.mul RNE t196 t196))
(define-fun t198 () Float64 (fp.add RNE t104 t197))
(define-fun t199 () Float64 (fp.sqrt RNE t198))
(define-fun t200 () Float64 (fp.div RNE t142 t199))
(define-fun t201 () Float64 (fp.mul RNE t99 t200))
(define-fun t202 () Float64 (fp.mul RNE t100 t200))
(define-fun t203 () Float64 (fp.mul RNE t196 t200))
(define-fun t204 () Float64 (fp.mul RNE t201 t201))
(define-fun t205 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t204))
(define-fun t206 () Float64 (fp.mul RNE t202 t202))
(define-fun t207 () Float64 (fp.add RNE t205 t206))
(define-fun t208 () Float64 (fp.mul RNE t203 t203))
(define-fun t209 () Float64 (fp.add RNE t207 t208))
(define-fun t210 () Float64 (fp.sqrt RNE t209))
(define-fun t211 () Bool (fp.leq t210 x0))
(define-fun t212 () Bool (fp.lt (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t155))
(define-fun t213 () Float64 (fp.div RNE x3 (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000)))
(define-fun t214 () Float64 (fp.mul RNE t213 t213))
(define-fun t215 () Float64 (fp.add RNE t121 t214))
(define-fun t216 () Float64 (fp.sqrt RNE t215))
(define-fun t217 () Float64 (fp.div RNE t142 t216))
(define-fun t218 () Float64 (fp.mul RNE t116 t217))
(define-fun t219 () Float64 (fp.mul RNE t117 t217))
(define-fun t220 () Float64 (fp.mul RNE t213 t217))
(define-fun t221 () Float64 (fp.mul RNE t218 t218))
(define-fun t222 () Float64 (fp.add RNE (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) t221))
(define-fun t223 () Float64 (fp.mul RNE t219 t219))
(define-fun t224 () Float64 (fp.add RNE t222 t223))
(define-fun t225 () Float64 (fp.mul RNE t220 t220))
(define-fun t226 () Float64 (fp.add RNE t224 t225))
(define-fun t227 () Float64 (fp.sqrt RNE t226))
(define-fun t228 () Bool (fp.leq t227 x0))
(define-fun t230 () Bool (fp.leq (fp #b0 #b00000000000 #b0000000000000000000000000000000000000000000000000000) x0))
(define-fun t232 () Bool (and t23 t139))
(push 1) ; every channel in m/s is within the limit
(assert t23)(assert (not t23))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t36)(assert (not t36))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t48)(assert (not t48))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t58)(assert (not t58))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t139)(assert (not t139))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t154)(assert (not t154))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t178)(assert (not t178))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t194)(assert (not t194))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t211)(assert (not t211))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t228)(assert (not t228))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert (not t228))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert t228)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert t228)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert (not t212))(assert t228)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert (not t178))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert (not t115))(assert t212)(assert t178)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert (not t194))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert t194)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert t194)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert (not t156))(assert t194)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert (not t178))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert (not t80))(assert t115)(assert t156)(assert t178)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert (not t211))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert t211)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert t211)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert (not t195))(assert t211)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert (not t178))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert (not t82))(assert t195)(assert t178)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert (not t194))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert t194)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert t194)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert (not t156))(assert t194)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert (not t178))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert t178)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert (not t140))(assert t80)(assert t82)(assert t156)(assert t178)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert t58)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert t48)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert (not t23))(assert t28)(assert t36)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert (not t154))(assert t7)(assert t23)(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert t154)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert t154)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert (not t139))(assert t140)(assert t154)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert t139)(assert t7)(assert (not t23))(assert (not t28))(assert (not t38))(assert (not t58))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert t139)(assert t7)(assert (not t23))(assert (not t28))(assert t38)(assert (not t48))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; every channel in m/s is within the limit
(assert t5)(assert t6)(assert t13)(assert t18)(assert t19)(assert t139)(assert t7)(assert (not t23))(assert t28)(assert (not t36))(assert (not t230))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t10))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t10)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t13)(assert (not t15))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t13))(assert (not (not t15)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert (not t18))(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t18)(assert (not t19))(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t18)(assert t19)(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t18))(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t18)(assert (not t19))(assert (not (not t26)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t59)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t59)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert (not (not t59)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert t18)(assert t19)(assert (not (not t59)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t13)(assert (not t18))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t13)(assert t18)(assert (not t19))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t7)(assert t13)(assert t18)(assert t19)(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t13)(assert (not t18))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert t13)(assert t18)(assert (not t19))(assert (not (not t132)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert (not t5))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert (not t6))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert t18)(assert t19)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; not finite exactly when so
(assert t5)(assert t6)(assert (not t13))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t139)(assert (not t139))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t139))(assert (not (not t139)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t23)(assert t139)(assert (not t232))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t23))(assert (not t139))(assert (not (not t232)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert (not t23))(assert t139)(assert (not (not t232)))
(check-sat)
(pop 1)
(push 1) ; says whether it changed something
(assert t23)(assert (not t139))(assert (not (not t232)))
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
(assert t5)(assert t6)(assert t7)(assert t13)(assert t18)(assert t19)(assert (not t134))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert (not t5))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert (not t6))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t7))(assert t13)(assert t18)(assert t19)(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert (not t13))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t13)(assert (not t18))(assert (not (not t134)))
(check-sat)
(pop 1)
(push 1) ; usable exactly when it can be limited
(assert t5)(assert t6)(assert t13)(assert t18)(assert (not t19))(assert (not (not t134)))
(check-sat)
(pop 1)
