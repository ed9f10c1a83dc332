using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Toolkit.Ragdolls;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A struck part that gives and recovers: joints from the struck one up to the trunk are thrown aside and come back as damped springs, on top of any motion.</summary>
internal sealed class Recoil
{
    /// <summary>Springs, 1/τ with τ = √(ℓ/g), and their damping.</summary>
    private const float Stiffness = 2.7f;
    private const float DampingRatio = 0.55f;

    /// <summary>Fastest throw of a joint and of all of a part together, 1/τ, and what of it each joint farther in takes: no blow turns a head by much more than a radian.</summary>
    private const float MaxRate = 3.4f;
    private const float MaxSum = 5.7f;
    private const float Inward = 0.7f;

    /// <summary>Radians below which it is over.</summary>
    private const float Over = 1e-3f;

    private readonly FallProfile profile;
    private readonly Vector3[] angles;
    private readonly Vector3[] rates;

    public Recoil(FallProfile profile)
    {
        this.profile = profile;
        angles = new Vector3[profile.Skeleton.Count];
        rates = new Vector3[angles.Length];
    }

    /// <summary>Whether anything is left of it.</summary>
    public bool IsActive { get; private set; }

    /// <summary>Strikes a part.</summary>
    /// <param name="joint">Of it.</param>
    /// <param name="impulse">World N·s.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="model">Its pose.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    public void Strike(int joint, Vector3 impulse, in RootPlace place, in Pose model, float tau)
    {
        Skeleton skeleton = profile.Skeleton;
        Vector3 hit = model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], skeleton.Joints[joint].Along * (0.5f * skeleton.Joints[joint].Length));
        Vector3 push = Rotation.Rotate(Rotation.Inverse(place.Rotation), impulse);
        float scale = place.Scale;
        float shares = 0f;
        float fraction = 1f;
        for (int j = joint; Gives(j); j = skeleton.Parents[j], fraction *= Inward)
        {
            shares += fraction;
        }

        float most = Math.Min(MaxRate, MaxSum / Math.Max(shares, 1f)) / tau;
        fraction = 1f;
        for (int j = joint; Gives(j); j = skeleton.Parents[j], fraction *= Inward)
        {
            // The moment of inertia of a larger one grows with the fifth power of its size, the lever with the first.
            Vector3 turn = Vec.Cross(hit - model.Positions[j], push) / (profile.Inertias[j] * scale * scale * scale * scale);
            float rate = Vec.Length(turn);
            turn *= fraction * Math.Min(1f, most / Math.Max(rate, 1e-6f));
            int parent = skeleton.Parents[j];
            rates[j] += parent < 0 ? turn : Rotation.Rotate(Rotation.Inverse(model.Rotations[parent]), turn);
            IsActive = true;
        }
    }

    /// <summary>Lays what is left of it on a pose.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="tau">√(ℓ/g), seconds.</param>
    /// <param name="local">In the parents' space.</param>
    public void Apply(float dt, float tau, in Pose local)
    {
        if (!IsActive)
        {
            return;
        }

        var spring = new DampedSpring(Stiffness / tau, DampingRatio, dt);
        float max = 0f;
        for (int j = 0; j < angles.Length; j++)
        {
            if (angles[j] == Vector3.Zero && rates[j] == Vector3.Zero)
            {
                continue;
            }

            (angles[j], rates[j]) = ((angles[j] * spring.PlaceOfPlace) + (rates[j] * spring.PlaceOfVelocity), (angles[j] * spring.VelocityOfPlace) + (rates[j] * spring.VelocityOfVelocity));
            float angle = Vec.Length(angles[j]);
            max = Math.Max(max, Math.Max(angle, tau * Vec.Length(rates[j])));
            if (angle > 1e-6f)
            {
                Quaternion turned = Rotation.Normalize(Rotation.Multiply(Rotation.FromAxisAngle(angles[j] / angle, angle), local.Rotations[j]));
                local.Rotations[j] = SwingTwistLimit.ClampLocal(turned, profile.Skeleton.Joints[j]);
            }
        }

        if (max < Over)
        {
            Stop();
        }
    }

    /// <summary>Whether a joint gives to blows.</summary>
    private bool Gives(int joint) => joint >= 0 && profile.Inertias[joint] > 0f;

    /// <summary>Ends it.</summary>
    public void Stop()
    {
        Array.Clear(angles, 0, angles.Length);
        Array.Clear(rates, 0, rates.Length);
        IsActive = false;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Recoil other)
    {
        other.angles.CopyTo(angles, 0);
        other.rates.CopyTo(rates, 0);
        IsActive = other.IsActive;
    }
}
