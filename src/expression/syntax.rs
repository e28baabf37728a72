//! An expression as a tree.

use super::functions::Function;
use std::ops::Range;

/// A step from a quantity to a part of it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Part {
    /// `.name`, or the list entry of that name: `["name"]`.
    Name(String),
    /// `[number]`, from 0.
    Index(usize),
    /// `[*]`: the following parts of every entry.
    All,
}

/// An operation, a number or a name, with the bytes of the text that it was read from.
#[derive(Clone, Debug)]
pub(super) struct Node {
    pub span: Range<usize>,
    pub form: Form,
}

/// Trees are equal where they compute the same, wherever they were read.
impl PartialEq for Node {
    fn eq(&self, other: &Self) -> bool {
        self.form == other.form
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(super) enum Form {
    Number(f64),
    Quantity(String, Vec<Part>),
    Call(Function, Vec<Node>),
    With(String, Box<Node>),
    At(Box<[Node; 3]>),
}

impl Node {
    fn parts(&self) -> &[Self] {
        match &self.form {
            Form::Call(_, parts) => parts,
            Form::With(_, inner) => std::slice::from_ref(inner),
            Form::At(parts) => &**parts,
            Form::Number(_) | Form::Quantity(..) => &[],
        }
    }

    pub(super) fn size(&self) -> usize {
        1 + self.parts().iter().map(Self::size).sum::<usize>()
    }

    /// Returns the number of operations evaluated one inside the other.
    pub(super) fn depth(&self) -> usize {
        1 + self.parts().iter().map(Self::depth).max().unwrap_or(0)
    }

    /// Returns the number of operators and calls.
    pub(super) fn operations(&self) -> usize {
        let own = usize::from(!matches!(self.form, Form::Number(_) | Form::Quantity(..)));
        own + self.parts().iter().map(Self::operations).sum::<usize>()
    }
}
