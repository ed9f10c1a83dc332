using System.Numerics;

namespace CreatureGen.Appearance;

/// <summary>The colours of a place without and with the full pattern, linear RGB, and the place as the pattern sees it.</summary>
internal readonly struct CoatRange
{
    public CoatRange(Vector3 plainUndercoat, Vector3 patternedUndercoat, float grain, Vector3 plain, Vector3 patterned, PatternPlace place)
    {
        PlainUndercoat = plainUndercoat;
        PatternedUndercoat = patternedUndercoat;
        Grain = grain;
        Plain = plain;
        Patterned = patterned;
        Place = place;
    }

    /// <summary>Below the markings, where the pattern does not show.</summary>
    public Vector3 PlainUndercoat { get; }

    /// <summary>Below the markings, where it shows fully.</summary>
    public Vector3 PatternedUndercoat { get; }

    /// <summary>Factor on what lies over the undercoat.</summary>
    public float Grain { get; }

    /// <summary>Where the pattern does not show.</summary>
    public Vector3 Plain { get; }

    /// <summary>Where it shows fully.</summary>
    public Vector3 Patterned { get; }

    /// <summary>The place.</summary>
    public PatternPlace Place { get; }
}
