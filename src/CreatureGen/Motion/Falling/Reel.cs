using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Motion.Falling;

/// <summary>A trunk that reels from a blow while its feet step after it: it tips over with the push, gives at the knees, and comes back as a damped spring.</summary>
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
    // Left side up, 0, nose up.
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
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public void Strike(Vector3 change, float tau)
    {
        // To the left its right side comes up, ahead its tail.
        rate += new Vector3(-change.X, 0f, -change.Z) * (TipRate / tau);
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

        var spring = new DampedSpring(Stiffness / tau, DampingRatio, dt);
        (tip, rate) = ((tip * spring.PlaceOfPlace) + (rate * spring.PlaceOfVelocity), (tip * spring.VelocityOfPlace) + (rate * spring.VelocityOfVelocity));
        IsActive = Vec.Length(tip) > Over || tau * Vec.Length(rate) > Over;
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

    /// <summary>Ends it.</summary>
    public void Stop()
    {
        tip = rate = Vector3.Zero;
        IsActive = false;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Reel other) => (tip, rate, IsActive) = (other.tip, other.rate, other.IsActive);
}
