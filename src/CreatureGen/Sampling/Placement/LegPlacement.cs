using CreatureGen.Blueprints;

namespace CreatureGen.Sampling.Placement;

/// <summary>A pair of legs where the rules put it; the left one is described. Metres at scale 1, model space.</summary>
/// <param name="Bone">Index of the measured bone that carries it.</param>
/// <param name="Site">The anatomical place.</param>
/// <param name="Socket">The cells it grows out of.</param>
/// <param name="Along">Distance of the root along the spine.</param>
/// <param name="RootZ">Place of the root along the ground.</param>
/// <param name="RootHeight">Height of the attachment point above the ground.</param>
/// <param name="TipHeight">Height of the foot above the ground: 0 for a leg that stands.</param>
/// <param name="RootRadius">Radius of the root along the body.</param>
/// <param name="Reach">Outward unit of a splayed leg; 0 for a leg under the body.</param>
/// <param name="Swing">How far the foot moves to the front and to the rear of its place in quick gaits.</param>
/// <param name="Foot">The sole.</param>
/// <param name="Shear">Forward lean: shift of the foot relative to the length; already in the sole's place.</param>
internal sealed record LegPlacement(
    int Bone,
    LimbSocket Site,
    SocketBlueprint Socket,
    double Along,
    double RootZ,
    double RootHeight,
    double TipHeight,
    double RootRadius,
    double Reach,
    double Swing,
    FootContact Foot,
    double Shear)
{
    /// <summary>Length of the leg: distance from the attachment point straight down to the ground, or to the foot of a leg that hangs.</summary>
    public double Length => RootHeight - TipHeight;

    /// <summary>The same legs with their feet set forward by <paramref name="metres"/> and their soles larger by a factor.</summary>
    public LegPlacement Corrected(double metres, double growth) =>
        this with { Foot = Foot.Shifted(metres).Grown(growth), Shear = Shear + (metres / Length) };
}

/// <summary>A pair of arms where the rules put it; the left one is described. Metres at scale 1.</summary>
/// <param name="Bone">Index of the measured bone that carries it.</param>
/// <param name="Site">The anatomical place.</param>
/// <param name="Socket">The cells it grows out of.</param>
/// <param name="Length">Length from shoulder to fingertips; never reaches the ground.</param>
/// <param name="RootRadius">Radius of the root along the body.</param>
internal sealed record ArmPlacement(int Bone, LimbSocket Site, SocketBlueprint Socket, double Length, double RootRadius);
