//! A stream that is written in large pieces, seeks included.

use std::io::{ErrorKind, Result, Seek, SeekFrom, Write};

/// Bytes that are held at the most.
const MOST: usize = 4 << 20;

/// Holds what is written until it is flushed, and lets the writer go back within it: the header of a chunk is written
/// after the chunk. `std::io::BufWriter` writes all out at every look at the position.
///
/// Like that one it must be flushed before it is dropped; what it holds is lost else.
#[derive(Debug)]
pub(crate) struct Held<W> {
    inner: W,
    bytes: Vec<u8>,
    /// Where the bytes begin in the stream, and where the next one goes among them.
    start: u64,
    at: usize,
}

impl<W: Write + Seek> Held<W> {
    /// Writes to a stream from where it stands.
    pub fn new(mut inner: W) -> Result<Self> {
        let start = inner.stream_position()?;
        Ok(Self { inner, bytes: Vec::new(), start, at: 0 })
    }

    /// The stream, with all that was held.
    pub fn into_inner(mut self) -> Result<W> {
        self.flush()?;
        Ok(self.inner)
    }

    /// Writes out what is held; the stream then stands where the next byte goes. What is left after an error is still
    /// held, and no byte is written twice.
    fn let_go(&mut self) -> Result<()> {
        let next = self.start + self.at as u64;
        while !self.bytes.is_empty() {
            let written = match self.inner.write(&self.bytes) {
                Ok(0) => return Err(ErrorKind::WriteZero.into()),
                Ok(written) => written,
                Err(error) if error.kind() == ErrorKind::Interrupted => 0,
                Err(error) => return Err(error),
            };
            self.bytes.drain(..written);
            self.start += written as u64;
            self.at = self.at.saturating_sub(written);
        }
        if self.start != next {
            self.start = self.inner.seek(SeekFrom::Start(next))?;
        }
        Ok(())
    }
}

impl<W: Write + Seek> Write for Held<W> {
    fn write(&mut self, data: &[u8]) -> Result<usize> {
        if self.at + data.len() > MOST {
            self.let_go()?;
        }
        let over = data.len().min(self.bytes.len() - self.at);
        self.bytes[self.at..][..over].copy_from_slice(&data[..over]);
        self.bytes.extend_from_slice(&data[over..]);
        self.at += data.len();
        Ok(data.len())
    }

    fn flush(&mut self) -> Result<()> {
        self.let_go()?;
        self.inner.flush()
    }
}

impl<W: Write + Seek> Seek for Held<W> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        let here = self.start + self.at as u64;
        let target = match to {
            SeekFrom::Start(target) => Some(target),
            SeekFrom::Current(by) => here.checked_add_signed(by),
            SeekFrom::End(_) => None,
        };
        if let Some(target) = target
            && (self.start..=self.start + self.bytes.len() as u64).contains(&target)
        {
            self.at = (target - self.start) as usize;
            return Ok(target);
        }
        self.let_go()?;
        self.start = self.inner.seek(to)?;
        Ok(self.start)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Cursor;

    /// The same writes and seeks with and without holding.
    fn play(stream: &mut (impl Write + Seek)) -> Vec<u64> {
        let mut places = Vec::new();
        let mut state = 7_u64;
        for k in 0..4000_u64 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let (length, far) = ((state >> 48) as usize % 9000, state >> 33);
            stream.write_all(&vec![k as u8; length]).unwrap();
            let here = stream.stream_position().unwrap();
            match far % 7 {
                0 => places.push(stream.seek(SeekFrom::Start(here - here.min(far % 20_000))).unwrap()),
                1 => places.push(stream.seek(SeekFrom::End(0)).unwrap()),
                2 => places.push(stream.seek(SeekFrom::Current(-(here.min(30) as i64))).unwrap()),
                3 => stream.flush().unwrap(),
                _ => places.push(here),
            }
        }
        places
    }

    /// Takes three bytes at a time, and none while it is full.
    struct Small(Cursor<Vec<u8>>, bool);

    impl Write for Small {
        fn write(&mut self, data: &[u8]) -> Result<usize> {
            if self.1 && self.0.get_ref().len() >= 6 {
                return Err(ErrorKind::StorageFull.into());
            }
            self.0.write(&data[..data.len().min(3)])
        }

        fn flush(&mut self) -> Result<()> {
            Ok(())
        }
    }

    impl Seek for Small {
        fn seek(&mut self, to: SeekFrom) -> Result<u64> {
            self.0.seek(to)
        }
    }

    #[test]
    fn limit_after_an_error_no_byte_is_lost_or_written_twice() {
        let mut held = Held::new(Small(Cursor::new(Vec::new()), true)).unwrap();
        held.write_all(b"0123456789").unwrap();
        assert_eq!(held.flush().unwrap_err().kind(), ErrorKind::StorageFull);
        held.write_all(b"ab").unwrap();
        held.inner.1 = false;
        assert_eq!(held.into_inner().unwrap().0.into_inner(), b"0123456789ab");
    }

    #[test]
    fn identity_what_is_held_arrives_where_it_was_written() {
        let (mut plain, mut held) = (Cursor::new(Vec::new()), Held::new(Cursor::new(Vec::new())).unwrap());
        assert_eq!(play(&mut plain), play(&mut held));
        assert!(held.seek(SeekFrom::Current(i64::MIN)).is_err());
        let held = held.into_inner().unwrap().into_inner();
        assert!(held.len() > 5 * MOST / 2 && held == plain.into_inner());
    }
}
