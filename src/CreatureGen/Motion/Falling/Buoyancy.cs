using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Floating;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>What water does to a body on legs: it slows down who wades, carries who would be under it, and lets go of who has ground under its feet again.</summary>
internal sealed class Buoyancy
{
    /// <summary>How much deeper than it floats water has to be that it swims in, so that it does not change to and fro, leg lengths.</summary>
    private const float Spare = 0.05f;

    /// <summary>The same for what a game moves: part of how deep it floats to which it is put under water.</summary>
    private const float FollowedDepth = 0.8f;

    /// <summary>Depth, part of that at which it floats, from which on water slows down who wades; how fast it is there, and where it begins to swim, cruises.</summary>
    private const float WadingDepth = 0.35f;
    private const float WadingSpeed = 7f;
    private const float SwimmingSpeed = 1.2f;

    /// <summary>How quickly the pose goes over from legs to water and back, τ = √(ℓ/g).</summary>
    private const float FadeTime = 1.8f;

    private readonly FloatProfile profile;
    private readonly ILocomotionMode inner;
    private readonly WalkingMode legs;
    private readonly Paddling paddling;
    private readonly FloatingGround felt = new();
    private readonly FallingFloor floor = new();
    private readonly PoseFade fade;

    public Buoyancy(FloatProfile profile, ILocomotionMode inner, WalkingMode legs)
    {
        this.profile = profile;
        this.inner = inner;
        this.legs = legs;
        paddling = new Paddling(profile);
        fade = new PoseFade(profile.Body.Skeleton);
    }

    /// <summary>Metres per second ahead, of the model.</summary>
    public float Speed => paddling.Speed;

    /// <summary>Place in the cycle of the legs, 0..1.</summary>
    public float Phase => paddling.Phase;

    /// <summary>Cycles per second.</summary>
    public float Frequency => paddling.Frequency;

    private float Room => Spare * profile.Body.LegLength;

    /// <summary>Ground as its feet feel it: who comes to deep water does not fall to its bed.</summary>
    public IGround FeltOf(IGround ground, in WaterReading water, in RootPlace place, in MotionSettings settings)
    {
        if (water.Ground == null)
        {
            return ground;
        }

        felt.Lay(water.Ground, settings.Up, (profile.Draught + (2f * Room)) * place.Scale);
        return felt;
    }

    /// <summary>Whether its feet are in water that slows it down, or deeper.</summary>
    public bool IsWet(in WaterReading water, in RootPlace place) => water.Ground != null && water.Depth > WadingDepth * profile.Draught * place.Scale;

    /// <summary>Whether water carries it that goes or falls: its feet would not reach the bed with its back out of the water.</summary>
    public bool IsDeep(in WaterReading water, in RootPlace place, in MotionSettings settings) => water.Ground != null
        && water.Depth >= (profile.Draught - Room) * place.Scale
        && BedDepth(water.Ground, place, settings) >= (profile.Draught + Room) * place.Scale;

    /// <summary>Whether who swims has ground under its feet.</summary>
    public bool IsAground(in WaterReading water, in RootPlace place, in MotionSettings settings) =>
        water.Ground == null || !(BedDepth(water.Ground, place, settings) > profile.Draught * place.Scale);

    /// <summary>Whether it swims where a game puts it.</summary>
    public bool Carries(in WaterReading water, in RootPlace place, in MotionSettings settings) => water.Ground != null
        && water.Depth >= FollowedDepth * profile.Draught * place.Scale
        && BedDepth(water.Ground, place, settings) >= (profile.Draught + Room) * place.Scale;

    /// <summary>What is asked of it, as fast as water lets it wade.</summary>
    public MotionInput Wade(in MotionInput input, in WaterReading water, in RootPlace place, in MotionSettings settings)
    {
        if (!IsWet(water, place))
        {
            return input;
        }

        float depth = water.Depth / (profile.Draught * place.Scale);
        float cruises = Scalar.Lerp(WadingSpeed, SwimmingSpeed, Scalar.Smooth((depth - WadingDepth) / (1f - WadingDepth)));
        float fastest = cruises * (float)Paddling.CruiseOf(profile.Body, paddling.Tau(place.Scale, settings.Gravity)) * place.Scale;
        return input with { Speed = Scalar.Clamp(input.Speed, -fastest, fastest), Sideways = Scalar.Clamp(input.Sideways, -fastest, fastest) };
    }

    /// <summary>Begins to swim.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="velocity">Of the body, world m/s.</param>
    /// <param name="yawRate">Radians per second.</param>
    /// <param name="shown">The pose shown last.</param>
    public void Begin(in RootPlace place, Vector3 velocity, float yawRate, in Pose shown)
    {
        legs.Sink = 0f;
        legs.Bow = 0f;
        fade.Keep(shown);
        paddling.Begin(Rotation.Rotate(Rotation.Inverse(place.Rotation), velocity) / place.Scale, yawRate);
    }

    /// <summary>Swims on, and poses it.</summary>
    public RootPlace Update(in RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        var water = (IWaterGround)ground;
        RootPlace next = paddling.Advance(place, dt, input, settings, water);
        paddling.Reach(BedDepth(water, next, settings) / next.Scale, next.Scale, settings.Gravity, dt);
        Pose(next, settings, ground, layer, local);
        return next;
    }

    /// <summary>Swims as the game moved it, and poses it.</summary>
    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        MotionInput asked = RootStep.Asked(place, dt, goal, MotionMedium.Ground);
        paddling.Follow(new Vector3(0f, 0f, asked.Speed / goal.Scale), asked.YawRate, goal.Scale, settings.Gravity, dt);
        paddling.Reach(BedDepth((IWaterGround)ground, goal, settings) / goal.Scale, goal.Scale, settings.Gravity, dt);
        Pose(goal, settings, ground, layer, local);
    }

    /// <summary>Has it walk on from where it swam.</summary>
    public void Leave(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        fade.Keep(local);
        if (inner == legs)
        {
            local.SetToRest(profile.Body.Skeleton);
            legs.Stand(place, settings, ground, layer, local);
            legs.SetOff(paddling.Speed, paddling.Turn);
        }
    }

    /// <summary>Lays on a pose what is left of the one before it came to water, or left it.</summary>
    public void Fade(in RootPlace place, float dt, in MotionSettings settings, in Pose local) => fade.Apply(dt, FadeTime * (float)paddling.Tau(place.Scale, settings.Gravity), local);

    /// <summary>Forgets the pose before.</summary>
    public void Stop() => fade.Stop();

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Buoyancy other)
    {
        paddling.CopyFrom(other.paddling);
        fade.CopyFrom(other.fade);
    }

    /// <summary>Depth of the bed under its root, metres; infinite where that is far below.</summary>
    private float BedDepth(IWaterGround water, in RootPlace place, in MotionSettings settings)
    {
        float above = profile.Draught * place.Scale;
        return water.Cast(place.Position + (settings.Up * above), -settings.Up, 2f * above, out GroundHit hit) ? water.DepthAt(hit.Point) : float.PositiveInfinity;
    }

    /// <summary>The body as it stands, wings folded, with trunk and legs as they swim.</summary>
    private void Pose(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        floor.Lay(place.Position, settings.Up);
        inner.Stand(place, settings, floor, layer, local);
        paddling.Pose(place, settings, ground, local);
    }
}
