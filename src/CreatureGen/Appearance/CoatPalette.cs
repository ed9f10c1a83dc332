using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The colours of a coat in linear RGB, and those that follow from them.</summary>
internal sealed class CoatPalette
{
    private static readonly Vector3 flesh = OklchColour.ToLinearRgb(0.66, 0.07, 0.52);

    /// <summary>Converts the colours of a blueprint.</summary>
    public CoatPalette(CoatBlueprint coat)
    {
        Base = OklchColour.ToLinearRgb(coat.Base);
        Back = OklchColour.ToLinearRgb(coat.Back);
        Belly = OklchColour.ToLinearRgb(coat.Belly);
        Limb = OklchColour.ToLinearRgb(coat.Limb);
        Pattern = OklchColour.ToLinearRgb(coat.Pattern);
        Accent = OklchColour.ToLinearRgb(coat.Accent);
        Claw = OklchColour.ToLinearRgb(coat.Claw);
        Horn = OklchColour.ToLinearRgb(coat.Horn);
        Muzzle = OklchColour.ToLinearRgb(coat.Muzzle);
        Mouth = OklchColour.ToLinearRgb(coat.Mouth);
        Tongue = OklchColour.ToLinearRgb(coat.Tongue);
        Iris = OklchColour.ToLinearRgb(coat.Iris);
    }

    public Vector3 Base { get; }

    public Vector3 Back { get; }

    public Vector3 Belly { get; }

    public Vector3 Limb { get; }

    public Vector3 Pattern { get; }

    public Vector3 Accent { get; }

    public Vector3 Claw { get; }

    public Vector3 Horn { get; }

    public Vector3 Muzzle { get; }

    public Vector3 Mouth { get; }

    public Vector3 Tongue { get; }

    public Vector3 Iris { get; }

    /// <summary>Inside of the ears: thinly haired flesh.</summary>
    public Vector3 EarInside => Vec.Lerp(flesh, Belly, 0.25f);

    /// <summary>Inside of the mouth, in its own shadow.</summary>
    public Vector3 MouthInside => Mouth * 0.5f;
}
