using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Modes;

/// <summary>A way to move a body that the animator calls: on legs, on wings, in water, on the belly. One instance for each creature on the scene.</summary>
internal interface ILocomotionMode
{
    /// <summary>Metres per second ahead at present, model space.</summary>
    float Speed { get; }

    /// <summary>Place in the cycle, 0..1.</summary>
    float Phase { get; }

    /// <summary>Cycles per second.</summary>
    float Frequency { get; }

    /// <summary>Whether feet carry it at present: not in the air, in water or on the belly.</summary>
    bool IsOnFeet { get; }

    /// <summary>Whether they do so wholly: no other way of moving has a part in the pose, but for wings that fold.</summary>
    bool StandsOnFeet { get; }

    /// <summary>Whether it holds nothing out that it folds away at rest.</summary>
    bool IsFolded { get; }

    /// <summary>Whether the start of a startled fish is under way.</summary>
    bool Escapes { get; }

    /// <summary>Height of the root above what tails must not go into, metres of the model; infinite where there is nothing.</summary>
    float Clearance { get; }

    /// <summary>How that goes on along the body: metres up for each metre ahead.</summary>
    float Incline { get; }

    /// <summary>How far the body leans to its left, radians, so that its weight and the turn that it flies balance: what hangs on it feels no push to the side. 0 where the ground or water carries it.</summary>
    float BalancedBank { get; }

    /// <summary>Moves on as asked and writes the pose.</summary>
    /// <param name="place">Where the creature is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="input">What it is to do; finite.</param>
    /// <param name="settings">How it goes.</param>
    /// <param name="ground">What it goes on, or over.</param>
    /// <param name="layer">What an act asks of trunk and feet that stand, and of wings; null for nothing. Who has none of them takes no notice.</param>
    /// <param name="local">Pose in the parents' space, at rest; the joints that move are written.</param>
    /// <returns>Where it is then.</returns>
    RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local);

    /// <summary>Moves on as the game moved it and writes the pose.</summary>
    /// <param name="place">Where the creature was.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="goal">Where it is now.</param>
    /// <param name="settings">How it goes.</param>
    /// <param name="ground">What it goes on, or over.</param>
    /// <param name="layer">What an act asks of trunk and feet that stand, and of wings; null for nothing. Who has none of them takes no notice.</param>
    /// <param name="local">Pose in the parents' space, at rest; the joints that move are written.</param>
    void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local);

    /// <summary>Stands, floats or lies at a place as if it had always been there, and writes the pose.</summary>
    void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local);

    /// <summary>Moves the origin of the world.</summary>
    void Rebase(Vector3 offset);

    /// <summary>Goes on from where another of the same kind and creature is: takes over all that it remembers. Nothing is allocated.</summary>
    void CopyFrom(ILocomotionMode other);
}
