using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A trunk that reels from a blow: it tips over with the push and comes back as a damped spring. On feet, which step after it, it gives at the knees; what floats in air or water turns about its centre of mass.</summary>
internal sealed class Reel
{
    /// <summary>Spring, 1/τ with τ = √(ℓ/g), and its damping.</summary>
    private const float Stiffness = 3f;
    private const float DampingRatio = 0.5f;

    /// <summary>Speed with which a trunk tips for a change of the body's speed of √(gℓ), 1/τ, and its greatest.</summary>
    private const float TipRate = 2.8f;
    private const float MaxRate = 1.6f;

    /// <summary>How far it gives at the knees, leg lengths for each radian that it is tipped.</summary>
    private const float Flexion = 0.35f;

    /// <summary>Radians below which it is over.</summary>
    private const float Over = 1e-3f;

    private readonly BodyLayer layer;
    private readonly float legLength;
    // Left side up, to the left, nose up.
    private Vector3 tip;
    private Vector3 rate;

    public Reel(int feet, float legLength)
    {
        layer = new BodyLayer(feet);
        this.legLength = legLength;
    }

    /// <summary>Whether it is tipped.</summary>
    public bool IsActive { get; private set; }

    /// <summary>Strikes the body.</summary>
    /// <param name="change">Of its speed, in its own axes, √(gℓ).</param>
    /// <param name="turn">How much of that is beside its middle and turns it to the left: 0 where feet hold it.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public void Strike(Vector3 change, float turn, float tau)
    {
        // To the left its right side comes up, ahead its tail.
        rate += new Vector3(-change.X, turn, -change.Z) * (TipRate / tau);
        rate *= Math.Min(1f, MaxRate / tau / Math.Max(Vec.Length(rate), 1e-6f));
        IsActive = true;
    }

    /// <summary>Goes on, and tells what is asked of the trunk.</summary>
    /// <param name="asked">What is asked of it besides; null for nothing.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public BodyLayer? On(BodyLayer? asked, float dt, float tau)
    {
        if (!IsActive)
        {
            return asked;
        }

        Advance(dt, tau);
        layer.Clear();
        if (asked != null)
        {
            layer.CopyFrom(asked);
        }

        float down = Flexion * Vec.Length(tip) * legLength;
        layer.Roll += tip.X;
        layer.Pitch += tip.Z;
        layer.ForeDown += down;
        layer.HindDown += down;
        return layer;
    }

    /// <summary>Goes on, and turns what nothing holds.</summary>
    /// <param name="body">Joint of the whole body.</param>
    /// <param name="centre">Its centre of mass, model space.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    /// <param name="local">Its pose in the parents' space.</param>
    public void Turn(int body, Vector3 centre, float dt, float tau, in Pose local)
    {
        if (IsActive)
        {
            Advance(dt, tau);
            Quaternion turn = AxisRotation.YawPitchRoll(tip.Y, -tip.Z, tip.X);
            local.Rotations[body] = Rotation.Normalize(Rotation.Multiply(turn, local.Rotations[body]));
            local.Positions[body] = centre + Rotation.Rotate(turn, local.Positions[body] - centre);
        }
    }

    /// <summary>Ends it.</summary>
    public void Stop()
    {
        tip = rate = Vector3.Zero;
        IsActive = false;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Reel other) => (tip, rate, IsActive) = (other.tip, other.rate, other.IsActive);

    private void Advance(float dt, float tau)
    {
        var spring = new DampedSpring(Stiffness / tau, DampingRatio, dt);
        (tip, rate) = ((tip * spring.PlaceOfPlace) + (rate * spring.PlaceOfVelocity), (tip * spring.VelocityOfPlace) + (rate * spring.VelocityOfVelocity));
        IsActive = Vec.Length(tip) > Over || tau * Vec.Length(rate) > Over;
    }
}
