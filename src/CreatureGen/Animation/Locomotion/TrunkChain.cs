using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Locomotion;

/// <summary>What turns a trunk: the pelvis as a whole, and the bends that its joints share. Radians, model axes; metres.</summary>
internal struct TrunkPlan
{
    /// <summary>Place of the pelvis joint.</summary>
    public Vector3 Pelvis;

    public float PelvisYaw;
    public float PelvisPitch;
    public float PelvisRoll;

    /// <summary>Bend from the pelvis to the joint of the fore legs.</summary>
    public float BendYaw;

    public float BendPitch;
    public float BendRoll;

    /// <summary>Turn of the chest of bipeds about the left axis, on top.</summary>
    public float ChestPitch;
}

/// <summary>Turns and places of the trunk's joints, pelvis to chest, in model space; turns are from rest.</summary>
internal sealed class TrunkChain
{
    private readonly Vector3[] offsets;
    private readonly int foreSlot;

    public TrunkChain(LeggedBody body)
    {
        int count = body.Trunk.Length;
        foreSlot = body.ForeSlot;
        offsets = new Vector3[count];
        Turns = new Quaternion[count];
        Positions = new Vector3[count];
        Rest = new Vector3[count];
        for (int i = 0; i < count; i++)
        {
            Rest[i] = body.Skeleton.ModelPositions[body.Trunk[i]];
            offsets[i] = i == 0 ? Vector3.Zero : Rest[i] - Rest[i - 1];
        }
    }

    public Quaternion[] Turns { get; }

    public Vector3[] Positions { get; }

    /// <summary>Places at rest.</summary>
    public Vector3[] Rest { get; }

    /// <summary>The turn of each joint relative to the one before.</summary>
    public Quaternion Bend { get; private set; } = Quaternion.Identity;

    /// <summary>The further turn of the last joint.</summary>
    public Quaternion ChestTurn { get; private set; } = Quaternion.Identity;

    /// <summary>Chains the joints.</summary>
    public void Apply(in TrunkPlan plan)
    {
        float share = 1f / Math.Max(foreSlot, 1);
        Bend = AxisTurn.YawPitchRoll(plan.BendYaw * share, plan.BendPitch * share, plan.BendRoll * share);
        ChestTurn = plan.ChestPitch == 0f ? Quaternion.Identity : AxisTurn.X(plan.ChestPitch);
        Turns[0] = AxisTurn.YawPitchRoll(plan.PelvisYaw, plan.PelvisPitch, plan.PelvisRoll);
        Positions[0] = plan.Pelvis;
        for (int i = 1; i < Turns.Length; i++)
        {
            Positions[i] = Positions[i - 1] + Rotation.Rotate(Turns[i - 1], offsets[i]);
            Turns[i] = i <= foreSlot ? Rotation.Multiply(Turns[i - 1], Bend) : Turns[i - 1];
        }

        int last = Turns.Length - 1;
        if (plan.ChestPitch != 0f && last > 0)
        {
            Turns[last] = Rotation.Multiply(Turns[last], ChestTurn);
        }
    }

    /// <summary>The turn of a joint relative to the one before.</summary>
    public Quaternion LocalTurn(int slot)
    {
        Quaternion turn = slot <= foreSlot ? Bend : Quaternion.Identity;
        return slot == Turns.Length - 1 ? Rotation.Multiply(turn, ChestTurn) : turn;
    }
}
