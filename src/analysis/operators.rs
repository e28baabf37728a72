//! Operators of number types in a line each.

/// Implements operators of `std::ops` whose result has the type of their left side.
macro_rules! operators {
    ($($trait:ident::$method:ident for $type:ty: |$left:ident $(, $right:ident: $other:ty)?| $result:expr;)*) => {
        $(impl std::ops::$trait$(<$other>)? for $type {
            type Output = Self;

            fn $method(self $(, $right: $other)?) -> Self {
                let $left = self;
                $result
            }
        })*
    };
}
pub(super) use operators;
