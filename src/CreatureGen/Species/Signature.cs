namespace CreatureGen.Species;

/// <summary>One trait that a creature is exaggerated in, so that it is remembered.</summary>
internal enum Signature
{
    None,
    BigHead,
    LongNeck,
    BigTail,
    Hulk,
    Rump,
    Hump,
    BigEyes,
    LongSnout,
}
