using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>What a foot remembers from update to update.</summary>
internal struct Foot
{
    /// <summary>Whether it is down.</summary>
    public FootPhase Phase;

    /// <summary>Where it is locked in stance, or comes from in a swing.</summary>
    public Foothold From;

    /// <summary>Where a swing goes.</summary>
    public Foothold To;

    /// <summary>Where a swing would go on level ground, followed smoothly: what is asked may change in mid step. World space.</summary>
    public Vector3 Wanted;

    /// <summary>Whether there is ground where it goes.</summary>
    public bool HasTarget;

    /// <summary>Shift of the target off an edge, along the foot, metres.</summary>
    public float Nudge;

    /// <summary>Place in the swing's share of the cycle at which it left the ground.</summary>
    public float LiftAt;

    /// <summary>Progress of the swing, 0..1.</summary>
    public float Swing;

    /// <summary>Progress of the stance, 0..1.</summary>
    public float Stance;

    /// <summary>Whether it leaves the ground when the gait has it do so next.</summary>
    public bool Steps;

    /// <summary>Whether it sits out a swing because it is where it should be.</summary>
    public bool Held;

    /// <summary>Whether the present swing has a target.</summary>
    public bool Aimed;

    /// <summary>Whether it swings by its own clock, out of step with the gait: a correction.</summary>
    public bool Correcting;

    /// <summary>Seconds of such a swing.</summary>
    public float Flight;

    /// <summary>How far its leg reached when that was last looked at, metres.</summary>
    public float Reached;

    /// <summary>By how much it missed its place then, metres.</summary>
    public float Missed;

    /// <summary>How far the joints of its leg kept it from lying on the ground as it should when it last stood, about half the angle in radians.</summary>
    public float Yield;

    /// <summary>Its pitch, fold and load, without a jump where it leaves the cycle.</summary>
    public PostureFade Posture;

    /// <summary>Load: 0 in the air, about 1 in the middle of stance.</summary>
    public readonly float Load => Posture.Shown.Load;

    /// <summary>Place under the ball in model space at present, the swing's lift not counted.</summary>
    public Vector3 Base;

    /// <summary>Where it left the ground and where it comes down, under the ball in model space at present; both where it stands.</summary>
    public Vector3 Start;
    public Vector3 End;

    /// <summary>What of its height above that place is for what stands in its way, metres.</summary>
    public float Over;

    /// <summary>Height above that place, metres.</summary>
    public float Lift;

    /// <summary>How far an act has taken it off the ground, 0..1: then it neither carries nor steps.</summary>
    public float Taken;

    /// <summary>Heading in model space at present.</summary>
    public Quaternion Heading;

    /// <summary>Normal of the ground in model space at present.</summary>
    public Vector3 Normal;

    /// <summary>From the hip to what the leg reaches for, when last posed, before the body was lowered for it. Model space.</summary>
    public Vector3 Chord;

    /// <summary>How far its leg drew the body down when it last stood or was about to, metres.</summary>
    public float Drawn;

    /// <summary>How far the body was lowered when it was last posed, metres.</summary>
    public float Lowered;

    /// <summary>The hip of its leg, when last posed. Model space.</summary>
    public Vector3 Hip;

    /// <summary>Length that the leg would need, as part of its reach, when last posed.</summary>
    public float Stretch;

    /// <summary>Distance by which the foot missed its place when last posed, metres.</summary>
    public float Residual;

    /// <summary>From where it was to be to where its leg brought it when last posed, the more of it the nearer it was to coming down. Model space.</summary>
    public Vector3 Astray;

    /// <summary>What users see of it.</summary>
    /// <param name="joint">Joint of its ball.</param>
    public readonly FootReport Report(int joint)
    {
        bool down = Phase == FootPhase.Stance;
        Foothold place = down ? From : To;
        return new FootReport(Taken > 0f ? FootPhase.Swing : Phase, joint, place.Position, place.Normal, down ? Stance : Swing, Load * (1f - Taken), Stretch, Residual);
    }

    /// <summary>Whether all feet are down.</summary>
    public static bool AllStand(ReadOnlySpan<Foot> feet)
    {
        bool stand = true;
        foreach (ref readonly Foot foot in feet)
        {
            stand &= foot.Phase == FootPhase.Stance;
        }

        return stand;
    }
}
