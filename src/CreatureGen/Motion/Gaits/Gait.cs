using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>A gait as data: when each foot comes down, for how long, how far, and how the body goes with it. Immutable; make your own, or change a copy with a <c>with</c> expression.</summary>
/// <remarks>Lengths are in leg lengths, so that one gait serves creatures of any size.</remarks>
/// <param name="Name">What it is called.</param>
/// <param name="Phases">When in the cycle each foot comes down.</param>
/// <param name="Duty">Part of the cycle that each foot is down.</param>
/// <param name="Stride">Length of a cycle on the ground.</param>
public sealed record Gait(string Name, LegPhases Phases, DutyLaw Duty, StrideLaw Stride)
{
    /// <summary>Least number of pairs of legs that it is for. Default: 1.</summary>
    public int MinRows { get; init; } = 1;

    /// <summary>Greatest number of pairs of legs that it is for. Default: any.</summary>
    public int MaxRows { get; init; } = int.MaxValue;

    /// <summary>Froude number of its most comfortable speed.</summary>
    public float Comfortable { get; init; } = 0.1f;

    /// <summary>Greatest Froude number at which it can be kept up.</summary>
    public float Fastest { get; init; } = 0.7f;

    /// <summary>Height of swinging feet, as a factor on that of the leg's build.</summary>
    public float Lift { get; init; } = 1f;

    /// <summary>Distance of the tracks of left and right feet, as a factor on that of standing.</summary>
    public float Track { get; init; } = 0.9f;

    /// <summary>Least lowering of the body while it moves, leg lengths.</summary>
    public float Crouch { get; init; } = 0.015f;

    /// <summary>How far the force of a foot dips in the middle of its stance (the M of walks), 0..1.</summary>
    public float ForceDip { get; init; }

    /// <summary>Share of the rise and fall that the forces of the feet ask for.</summary>
    public float Bounce { get; init; } = 1f;

    /// <summary>Most that one harmonic of the rise and fall may have as amplitude, leg lengths.</summary>
    public float BounceCap { get; init; } = 0.035f;

    /// <summary>Exaggeration of sway and roll: what is physically right reads as weak in walks.</summary>
    public float Emphasis { get; init; } = 1f;

    /// <summary>Where the fore feet of quadrupeds come down, stance lengths ahead of straight under the shoulder.</summary>
    public float ForeBias { get; init; } = -0.09f;

    /// <summary>Where the hind feet, and those of bipeds, come down, stance lengths ahead of straight under the hip.</summary>
    public float HindBias { get; init; } = 0.05f;

    /// <summary>How far bipeds lean ahead, as a factor on their own lean at a walk.</summary>
    public float Lean { get; init; } = 1f;

    /// <summary>How far arms are bent while they swing, radians.</summary>
    public float ElbowBend { get; init; }

    /// <summary>How far the legs ahead of the hindmost pair are folded up to the body in the air, 0..1. Default: 0, their feet go from place to place.</summary>
    public float Tuck { get; init; }

    /// <summary>How far the hindmost legs are stretched out behind in the air before they are drawn in, 0..1. Default: 0, their feet go from place to place.</summary>
    public float Trail { get; init; }

    /// <summary>How far legs that push off and come down are stretched, part of what they stand bent by, 0..1: the body flies higher by as much. Default: 0, the body is at its height as feet come down.</summary>
    public float Stretch { get; init; }

    /// <summary>How far the trunk of bipeds is thrown up with the push and dips to the landing, radians. Default: 0.</summary>
    public float Rock { get; init; }

    /// <summary>How far the back is arched in the air where all feet fly at once, and hollowed as they push, radians: beside what the feet's gathering bends it. Default: 0.</summary>
    public float Arch { get; init; }

    /// <summary>Whether the feet of a girdle do different things on the left and on the right for ever: such a gait leads with the side that the creature turns to.</summary>
    public GaitSymmetry Symmetry { get; init; } = GaitSymmetry.Symmetric;

    /// <summary>Passes a sound gait.</summary>
    /// <exception cref="ArgumentException">A number is not finite or out of its range; the message says which.</exception>
    public void ThrowIfInvalid()
    {
        if (string.IsNullOrEmpty(Name) || Phases == null)
        {
            throw new ArgumentException("a gait has no name or no phases; expected both");
        }

        Finite.RequireWithin(Duty.Min, 0.05f, 0.95f, Name + ".Duty.Least");
        Finite.RequireWithin(Duty.Max, Duty.Min, 0.95f, Name + ".Duty.Max");
        Finite.Require(Duty.Intercept, Name + ".Duty.Intercept");
        Finite.Require(Duty.Slope, Name + ".Duty.Slope");
        Finite.RequireWithin(Stride.Factor, 0.1f, 20f, Name + ".Stride.Factor");
        Finite.RequireWithin(Stride.Exponent, 0f, 0.5f, Name + ".Stride.Exponent");
        Finite.RequireWithin(Comfortable, 1e-3f, 100f, Name + ".Comfortable");
        Finite.RequireWithin(Fastest, Comfortable, 100f, Name + ".Fastest");
        Finite.RequireWithin(Lift, 0f, 5f, Name + ".Lift");
        Finite.RequireWithin(Track, 0f, 2f, Name + ".Track");
        Finite.RequireWithin(Crouch, 0f, 0.3f, Name + ".Crouch");
        Finite.RequireWithin(ForceDip, 0f, 1f, Name + ".ForceDip");
        Finite.RequireWithin(Bounce, 0f, 2f, Name + ".Bounce");
        Finite.RequireWithin(BounceCap, 0f, 0.5f, Name + ".BounceCap");
        Finite.RequireWithin(Emphasis, 0f, 3f, Name + ".Emphasis");
        Finite.RequireWithin(ForeBias, -0.5f, 0.5f, Name + ".ForeBias");
        Finite.RequireWithin(HindBias, -0.5f, 0.5f, Name + ".HindBias");
        Finite.RequireWithin(Lean, -10f, 10f, Name + ".Lean");
        Finite.RequireWithin(ElbowBend, 0f, 2f, Name + ".ElbowBend");
        Finite.RequireWithin(Tuck, 0f, 1f, Name + ".Tuck");
        Finite.RequireWithin(Trail, 0f, 1f, Name + ".Trail");
        Finite.RequireWithin(Stretch, 0f, 1f, Name + ".Stretch");
        Finite.RequireWithin(Rock, 0f, 1f, Name + ".Rock");
        Finite.RequireWithin(Arch, 0f, 1f, Name + ".Arch");
    }
}

/// <summary>Whether left and right are alike in a gait.</summary>
public enum GaitSymmetry
{
    /// <summary>Left and right do the same, half a cycle apart or together.</summary>
    Symmetric,

    /// <summary>Left and right differ: one of them leads.</summary>
    Leading,
}
