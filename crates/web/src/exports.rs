//! Functions that the page calls: for the place of a question, to ask it, and for the answer's place and length in the
//! module's memory. Question and answer are JSON.

use std::cell::RefCell;
use std::sync::Arc;
use tribodyn::{SearchObserver, SearchStage, SearchWatch};

#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Tells the page what a search is at: place and length of a text, and a cage speed or NaN.
    safe fn stage(place: usize, length: usize, cage_speed_rpm: f64);
}

thread_local! {
    static QUESTION: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static ANSWER: RefCell<String> = const { RefCell::new(String::new()) };
}

struct Page;

impl SearchObserver for Page {
    fn stage(&self, told: SearchStage) {
        let rpm = told.cage_speed.map_or(f64::NAN, |speed| speed * 30.0 / std::f64::consts::PI);
        stage(told.name.as_ptr() as usize, told.name.len(), rpm);
    }

    /// The page ends a search with its worker.
    fn stops(&self) -> bool {
        false
    }
}

/// Place of a question of so many bytes, for the page to write it to.
#[unsafe(no_mangle)]
pub extern "C" fn tribodyn_question(length: usize) -> usize {
    QUESTION.with_borrow_mut(|question| {
        *question = vec![0; length];
        question.as_mut_ptr() as usize
    })
}

/// Answers the question that was written; the place of the answer, which stays until the next one.
#[unsafe(no_mangle)]
pub extern "C" fn tribodyn_ask() -> usize {
    let question = QUESTION.with_borrow(|question| String::from_utf8_lossy(question).into_owned());
    let answer = crate::ask(&question, &SearchWatch::new(Arc::new(Page)));
    ANSWER.replace(answer);
    ANSWER.with_borrow(|answer| answer.as_ptr() as usize)
}

/// Length of the answer in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn tribodyn_answer_length() -> usize {
    ANSWER.with_borrow(String::len)
}
