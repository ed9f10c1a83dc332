namespace CreatureGen.Anatomy;

/// <summary>The family of a beak.</summary>
public enum BeakStyle
{
    /// <summary>A short straight cone (hen, finch).</summary>
    Conical,

    /// <summary>A hook over a shorter lower bill, with a cere (eagle, owl).</summary>
    Hooked,

    /// <summary>Long and thin, a little bent down (heron, ibis).</summary>
    Probe,

    /// <summary>Broad and flat, with a nail at its rounded end (duck).</summary>
    Flat,

    /// <summary>High and round, bent down from its root, with a cere (parrot).</summary>
    Parrot,

    /// <summary>High and long, with a keel along its top and a dark tip (toucan, hornbill).</summary>
    Large,
}
