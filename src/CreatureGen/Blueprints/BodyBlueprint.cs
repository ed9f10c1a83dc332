using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Blueprints;

/// <summary>The trunk from nose to tail.</summary>
/// <param name="Blend">Which base bodies are mixed.</param>
/// <param name="Proportions">Factors on parts of the mixed body.</param>
/// <param name="Posture">Angles added to the mixed body's spine.</param>
/// <param name="Slices">The 11 slices of the 3 × 3 × 11 lattice, nose to tail.</param>
/// <param name="Elevation">Height of the spine at the anchor ring above the ground, metres at scale 1.</param>
/// <param name="Shell">Hard cover over the back.</param>
/// <param name="Annuli">Rings that the rear of the body is divided into.</param>
/// <param name="Disc">How the edges of a body as wide as a ray's lie.</param>
public sealed record BodyBlueprint(
    BodyBlend Blend,
    BodyProportions Proportions,
    BodyPosture Posture,
    ValueList<LatticeSlice> Slices,
    double Elevation,
    ShellBlueprint Shell,
    AnnuliBlueprint Annuli,
    DiscBlueprint Disc)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Body);
}

/// <summary>Base bodies mixed one after another, each region of the body in its own shares; and which of them gives what no number says.</summary>
/// <param name="Bodies">The bodies, 1 to 6. The mix starts as the first of them.</param>
/// <param name="Face">The base body whose kin the head is: beak or soft nose, nostrils, lids, width of the tongue.</param>
/// <param name="Skin">The base body whose kin the skin is: fur, feathers, scales, plates or bare.</param>
/// <param name="Manner">The base body whose kin it stands and goes like.</param>
public sealed record BodyBlend(ValueList<MixedBody> Bodies, string Face, string Skin, string Manner)
{
    /// <summary>Three bodies mixed as lerp(lerp(first, second, secondWeight), third, thirdWeight), alike in all regions, with face, skin and manner of the first.</summary>
    /// <param name="first">Name of the base body that the mix starts from.</param>
    /// <param name="second">Name of the second base body.</param>
    /// <param name="third">Name of the third base body.</param>
    /// <param name="secondWeight">0..1.</param>
    /// <param name="thirdWeight">0..1.</param>
    public static BodyBlend Of(string first, string second, string third, double secondWeight, double thirdWeight) => new(
        new ValueList<MixedBody>(new[]
        {
            new MixedBody(first, 1, 1, 1),
            new MixedBody(second, secondWeight, secondWeight, secondWeight),
            new MixedBody(third, thirdWeight, thirdWeight, thirdWeight),
        }),
        first,
        first,
        first);

    /// <summary>Name of the body that the mix starts from.</summary>
    public string First => Bodies[0].Name;

    /// <summary>Shares of the bodies in the torso, in their order; together 1.</summary>
    public IReadOnlyList<double> TorsoFractions => FractionsOf(part => part.Torso);

    /// <summary>Shares of the bodies in the head, in their order; together 1.</summary>
    public IReadOnlyList<double> HeadFractions => FractionsOf(part => part.Head);

    /// <summary>Shares of the bodies in the tail, in their order; together 1.</summary>
    public IReadOnlyList<double> TailFractions => FractionsOf(part => part.Tail);

    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Blend);

    private double[] FractionsOf(Func<MixedBody, double> weightOf)
    {
        double[] fractions = new double[Bodies.Count];
        double left = 1;
        for (int i = fractions.Length - 1; i >= 0; i--)
        {
            double weight = i == 0 ? 1 : weightOf(Bodies[i]);
            fractions[i] = left * weight;
            left *= 1 - weight;
        }

        return fractions;
    }
}

/// <summary>One of the bodies of a mix. A weight says how far this body draws the mix of those before it to itself in a region: 0 leaves it as it is, 1 replaces it; that of the first body does not count.</summary>
/// <param name="Name">Name of a base body.</param>
/// <param name="Torso">Weight in the torso, 0..1.</param>
/// <param name="Head">Weight in the head, 0..1; over the neck it goes over into that of the torso.</param>
/// <param name="Tail">Weight in the tail, 0..1; over the rump it goes over into that of the torso.</param>
public sealed record MixedBody(string Name, double Torso, double Head, double Tail)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Mixed);
}

/// <summary>Factors on parts of the body; 1 leaves a part as the base bodies give it.</summary>
/// <param name="Head">Size of the head.</param>
/// <param name="Snout">Length of the snout.</param>
/// <param name="Neck">Length of the neck.</param>
/// <param name="NeckGirth">Thickness of the neck.</param>
/// <param name="Girth">Thickness of the torso.</param>
/// <param name="Belly">Depth of the belly.</param>
/// <param name="Chest">Thickness of the chest.</param>
/// <param name="Hump">Height of the shoulders.</param>
/// <param name="Rump">Thickness of the hips.</param>
/// <param name="Tail">Length of the tail.</param>
/// <param name="TailGirth">Thickness of the tail's root.</param>
/// <param name="Depth">Height of the whole body against its width (fish are deep).</param>
/// <param name="Width">Width of the whole body.</param>
public sealed record BodyProportions(
    double Head,
    double Snout,
    double Neck,
    double NeckGirth,
    double Girth,
    double Belly,
    double Chest,
    double Hump,
    double Rump,
    double Tail,
    double TailGirth,
    double Depth,
    double Width)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Proportions);
}

/// <summary>Angles in radians added to the pitch of parts of the spine; positive raises what lies in front.</summary>
/// <param name="Head">Tilt of the head.</param>
/// <param name="Neck">Tilt of the neck.</param>
/// <param name="Torso">Tilt of the chest and belly (uprights).</param>
/// <param name="Tail">Tilt of the tail; positive lowers it.</param>
/// <param name="Trunk">Tilt of all behind the head as one.</param>
/// <param name="NeckBend">Bend of each neck bone relative to the one behind it; the sum over the neck stays within 100°.</param>
/// <param name="TailBend">Bend of each tail bone relative to the one before it; the sum over the tail stays within 100°.</param>
public sealed record BodyPosture(double Head, double Neck, double Torso, double Tail, double Trunk, double NeckBend, double TailBend)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Posture);
}

/// <summary>One slice of the lattice: factors on its width and height, and on its distance from the slice before it.</summary>
/// <param name="Width">Factor in x.</param>
/// <param name="Height">Factor in y.</param>
/// <param name="Length">Factor on the step along the body; steps add up, so slices never pass one another.</param>
public sealed record LatticeSlice(double Width, double Height, double Length)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Slice);
}

/// <summary>A hard cover over the back: the skin itself, swollen.</summary>
/// <param name="Style">Its form; nothing else counts for none.</param>
/// <param name="Ring">First ring.</param>
/// <param name="Rows">Number of rings behind the first.</param>
/// <param name="Columns">Number of segments down each side from the midline.</param>
/// <param name="Rise">How far it stands off the body, relative to the body's section.</param>
public sealed record ShellBlueprint(ShellStyle Style, int Ring, int Rows, int Columns, double Rise)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Shell);
}

/// <summary>Rings of a body that is divided like an insect's abdomen, three rings of the grid each, to the end of the tail.</summary>
/// <param name="Ring">First ring.</param>
/// <param name="Depth">How far the grooves go in, relative to the section; 0 for a smooth body.</param>
public sealed record AnnuliBlueprint(int Ring, double Depth)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Annuli);
}

/// <summary>The edges of a body that is as wide as wings.</summary>
/// <param name="Sweep">How far they lie back: metres at one metre from the midline, at scale 1.</param>
/// <param name="Curl">How far they are raised: metres at one metre from the midline, at scale 1; negative when they hang.</param>
public sealed record DiscBlueprint(double Sweep, double Curl)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, BodyFields.Disc);
}
