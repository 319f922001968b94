//! Saved states as bytes: little-endian numbers under a seal by which damaged and foreign bytes are known.
//!
//! Layout: a mark of 8 bytes with the format's version, length of the whole (u64), identity of what the bytes belong to
//! (u128), content, hash of all before (u128). The hash is XXH3-128 (Y. Collet, xxHash): fast, and no defence against forgers.

use twox_hash::XxHash3_128;

/// The mark at the beginning of a kind of saved state.
pub(crate) type Mark = [u8; 8];

/// Bytes before the content.
pub(crate) const HEADER: usize = size_of::<Mark>() + size_of::<u64>() + size_of::<u128>();
/// Bytes after the content.
pub(crate) const CHECKSUM: usize = size_of::<u128>();

/// 128-bit hash: of saved states, reduced models and all that a guid stands for.
pub(crate) fn hash(bytes: &[u8]) -> u128 {
    XxHash3_128::oneshot(bytes)
}

/// Why bytes are not a saved state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BrokenSeal {
    /// They begin with another mark.
    Mark,
    /// They are too few or too many.
    Length {
        /// As recorded, if that is there.
        expected: Option<u64>,
    },
    /// They are not those that were sealed.
    Checksum,
    /// They belong to something else.
    Identity,
}

/// Appends to bytes what `write` writes, under a seal. Allocates only where `bytes` lacks room.
pub(crate) fn seal(bytes: &mut Vec<u8>, mark: &Mark, identity: u128, write: impl FnOnce(&mut Writer)) {
    let begin = bytes.len();
    bytes.extend_from_slice(mark);
    bytes.extend_from_slice(&0_u64.to_le_bytes());
    bytes.extend_from_slice(&identity.to_le_bytes());
    write(&mut Writer { bytes });
    let length = (bytes.len() - begin + CHECKSUM) as u64;
    bytes[begin + mark.len()..][..size_of::<u64>()].copy_from_slice(&length.to_le_bytes());
    let checksum = hash(&bytes[begin..]);
    bytes.extend_from_slice(&checksum.to_le_bytes());
}

/// The content of bytes whose seal is whole and of this mark and identity.
pub(crate) fn open<'a>(bytes: &'a [u8], mark: &Mark, identity: u128) -> Result<Reader<'a>, BrokenSeal> {
    let mut header = Reader { bytes };
    if header.take() != Some(*mark) {
        return Err(BrokenSeal::Mark);
    }
    let expected = header.take().map(u64::from_le_bytes);
    if expected != Some(bytes.len() as u64) || bytes.len() < HEADER + CHECKSUM {
        return Err(BrokenSeal::Length { expected });
    }
    let (sealed, checksum) = bytes.split_at(bytes.len() - CHECKSUM);
    if checksum != hash(sealed).to_le_bytes() {
        return Err(BrokenSeal::Checksum);
    }
    if header.take().map(u128::from_le_bytes) != Some(identity) {
        return Err(BrokenSeal::Identity);
    }
    Ok(Reader { bytes: &sealed[HEADER..] })
}

/// Appends.
pub(crate) struct Writer<'a> {
    bytes: &'a mut Vec<u8>,
}

impl<'a> Writer<'a> {
    /// Appends to bytes, without a seal.
    pub fn new(bytes: &'a mut Vec<u8>) -> Self {
        Writer { bytes }
    }

    pub fn byte(&mut self, byte: u8) {
        self.bytes.push(byte);
    }

    pub fn flag(&mut self, flag: bool) {
        self.byte(u8::from(flag));
    }

    pub fn count(&mut self, count: u32) {
        self.bytes.extend_from_slice(&count.to_le_bytes());
    }

    pub fn integer(&mut self, integer: i32) {
        self.bytes.extend_from_slice(&integer.to_le_bytes());
    }

    pub fn real(&mut self, number: f64) {
        self.bytes.extend_from_slice(&number.to_le_bytes());
    }

    pub fn optional_real(&mut self, number: Option<f64>) {
        self.flag(number.is_some());
        self.real(number.unwrap_or_default());
    }

    pub fn reals(&mut self, numbers: impl IntoIterator<Item = f64>) {
        numbers.into_iter().for_each(|number| self.real(number));
    }

    /// Makes room for so many more bytes and a checksum.
    pub fn reserve(&mut self, content: usize) {
        self.bytes.reserve(content + CHECKSUM);
    }
}

/// Reads from the front; `None` where the bytes end or say nothing that a [`Writer`] writes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reader<'a> {
    bytes: &'a [u8],
}

impl Reader<'_> {
    /// Bytes that are left.
    pub fn left(&self) -> usize {
        self.bytes.len()
    }

    /// Leaves bytes out.
    pub fn skip(&mut self, count: usize) -> Option<()> {
        self.bytes = self.bytes.get(count..)?;
        Some(())
    }

    pub fn byte(&mut self) -> Option<u8> {
        self.take().map(|[byte]| byte)
    }

    pub fn flag(&mut self) -> Option<bool> {
        match self.byte()? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }

    pub fn count(&mut self) -> Option<u32> {
        self.take().map(u32::from_le_bytes)
    }

    pub fn integer(&mut self) -> Option<i32> {
        self.take().map(i32::from_le_bytes)
    }

    pub fn real(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    pub fn optional_real(&mut self) -> Option<Option<f64>> {
        let (is_there, number) = (self.flag()?, self.real()?);
        Some(is_there.then_some(number))
    }

    /// Fills places with the numbers that come.
    pub fn reals<'p>(&mut self, places: impl IntoIterator<Item = &'p mut f64>) -> Option<()> {
        places.into_iter().try_for_each(|place| {
            *place = self.real()?;
            Some(())
        })
    }

    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (front, rest) = self.bytes.split_first_chunk()?;
        self.bytes = rest;
        Some(*front)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MARK: Mark = *b"examples";

    fn sealed() -> Vec<u8> {
        let mut bytes = vec![7];
        seal(&mut bytes, &MARK, 5, |writer| {
            writer.flag(true);
            writer.count(3);
            writer.integer(-2);
            writer.optional_real(None);
            writer.optional_real(Some(-0.5));
            writer.reals([1.0, f64::NAN]);
        });
        assert_eq!(bytes.remove(0), 7, "what was there stays");
        bytes
    }

    #[test]
    fn what_is_sealed_is_read_again() {
        let bytes = sealed();
        let mut reader = open(&bytes, &MARK, 5).unwrap();
        assert_eq!((reader.flag(), reader.count(), reader.integer()), (Some(true), Some(3), Some(-2)));
        assert_eq!((reader.optional_real(), reader.optional_real()), (Some(None), Some(Some(-0.5))));
        let mut numbers = [0.0; 2];
        assert_eq!(reader.reals(&mut numbers), Some(()));
        assert!(numbers[0] == 1.0 && numbers[1].is_nan());
        assert_eq!((reader.left(), reader.real()), (0, None));
    }

    #[test]
    fn bytes_that_were_changed_cut_off_or_meant_for_others_are_told_apart() {
        let bytes = sealed();
        let found = |bytes: &[u8], mark: &Mark, identity| open(bytes, mark, identity).unwrap_err();
        assert_eq!(found(&bytes, b"EXAMPLES", 5), BrokenSeal::Mark);
        assert_eq!(found(&bytes, &MARK, 6), BrokenSeal::Identity);
        for end in 0..bytes.len() {
            assert!(matches!(found(&bytes[..end], &MARK, 5), BrokenSeal::Mark | BrokenSeal::Length { .. }));
        }
        for at in 16..bytes.len() {
            let mut changed = bytes.clone();
            changed[at] ^= 1;
            assert_eq!(found(&changed, &MARK, 5), BrokenSeal::Checksum, "{at}");
        }
    }

    #[test]
    fn the_hash_is_xxh3() {
        // XXH3_128bits of libxxhash 0.8.1.
        let long: Vec<u8> = (0..5000_u32).map(|i| (i % 251) as u8).collect();
        assert_eq!(hash(b""), 0x99aa_06d3_0147_98d8_6001_c324_468d_497f);
        assert_eq!(hash(b"a"), 0xa96f_af70_5af1_6834_e6c6_32b6_1e96_4e1f);
        assert_eq!(hash(&long), 0xb92e_c02c_39d3_3ce7_b418_500f_c423_20ee);
    }
}
