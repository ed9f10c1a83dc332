using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;

namespace CreatureGen.Motion.Walking.Trunk;

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

    /// <summary>Adds what an act asks of hips and back, as far as the trunk bends.</summary>
    public void Add(BodyLayer? layer, TrunkBends bends, ref float foreRise)
    {
        var asked = new Vector3(BendPitch, BendYaw, BendRoll);
        if (layer != null)
        {
            foreRise -= layer.ForeDown;
            Pelvis.Y -= layer.HindDown;
            asked += new Vector3(-layer.BackPitch, layer.BackSide, layer.BackTwist);
        }

        var most = new Vector3(bends.Pitch, bends.Yaw, bends.Roll);
        Vector3 bend = bends.Within(Vec.Max(Vec.Min(asked, most), -most));
        (BendPitch, BendYaw, BendRoll) = (bend.X, bend.Y, bend.Z);
    }
}

/// <summary>Turns and places of the trunk's joints, pelvis to chest, in model space; turns are from rest.</summary>
internal sealed class TrunkChain
{
    private readonly LeggedBody body;
    private readonly Vector3[] bent;
    private readonly Quaternion[] bends;

    /// <summary>Turns and places as if the front were not raised; none of bodies that raise none.</summary>
    private readonly (Quaternion Turn, Vector3 Position)[] lowered;

    public TrunkChain(LeggedBody body)
    {
        int count = body.Trunk.Length;
        this.body = body;
        bent = new Vector3[count];
        bends = new Quaternion[count];
        lowered = new (Quaternion, Vector3)[body.Front.Exists ? count : 0];
        Turns = new Quaternion[count];
        Positions = new Vector3[count];
    }

    public Quaternion[] Turns { get; }

    public Vector3[] Positions { get; }

    /// <summary>Places at rest.</summary>
    public Vector3[] Rest => body.TrunkRest;

    /// <summary>The turn of each joint relative to the one before.</summary>
    public Quaternion Bend { get; private set; } = Quaternion.Identity;

    /// <summary>The further turn of the last joint.</summary>
    public Quaternion ChestTurn { get; private set; } = Quaternion.Identity;

    /// <summary>The further turn of each joint of the front that an act raises.</summary>
    private Quaternion FrontTurn { get; set; } = Quaternion.Identity;

    /// <summary>Whether an act raises the front.</summary>
    public bool IsRaised { get; private set; }

    /// <summary>Asks memory for the joints.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch()
    {
        int count = body.Trunk.Length;
        return MemoryLines.Touch(bent, count) ^ MemoryLines.Touch(bends, count) ^ MemoryLines.Touch(Turns, count) ^ MemoryLines.Touch(Positions, count);
    }

    /// <summary>Bends the chain, as seen from the pelvis.</summary>
    /// <returns>From the pelvis to the joint of the fore legs.</returns>
    public Vector3 Flex(in TrunkPlan plan)
    {
        int foreSlot = body.ForeSlot;
        float fraction = 1f / Math.Max(foreSlot, 1);
        Bend = AxisRotation.YawPitchRoll(plan.BendYaw * fraction, plan.BendPitch * fraction, plan.BendRoll * fraction);
        ChestTurn = plan.ChestPitch == 0f ? Quaternion.Identity : AxisRotation.Pitch(plan.ChestPitch);
        Vector3[] rest = Rest;
        bends[0] = Quaternion.Identity;
        bent[0] = Vector3.Zero;
        for (int i = 1; i < bends.Length; i++)
        {
            bent[i] = bent[i - 1] + Rotation.Rotate(bends[i - 1], rest[i] - rest[i - 1]);
            bends[i] = i <= foreSlot ? Rotation.Multiply(bends[i - 1], Bend) : bends[i - 1];
        }

        int last = bends.Length - 1;
        if (plan.ChestPitch != 0f && last > 0)
        {
            bends[last] = Rotation.Multiply(bends[last], ChestTurn);
        }

        return bent[foreSlot];
    }

    /// <summary>Places the bent chain, and moves it as an act asks.</summary>
    public void Apply(in TrunkPlan plan, BodyLayer? layer)
    {
        Quaternion pelvis = AxisRotation.YawPitchRoll(plan.PelvisYaw, plan.PelvisPitch, plan.PelvisRoll);
        for (int i = 0; i < bends.Length; i++)
        {
            Turns[i] = Rotation.Multiply(pelvis, bends[i]);
            Positions[i] = plan.Pelvis + Rotation.Rotate(pelvis, bent[i]);
        }

        IsRaised = false;
        if (layer != null)
        {
            Move(layer);
            Raise(plan, layer);
        }
    }

    /// <summary>How far a place that goes with a joint of the trunk goes as the front is raised.</summary>
    /// <param name="slot">The joint.</param>
    /// <param name="from">A place on it as if nothing were raised.</param>
    /// <param name="turn">How far it is turned.</param>
    public Vector3 Carry(int slot, Vector3 from, out Quaternion turn)
    {
        turn = Rotation.Multiply(Turns[slot], Rotation.Inverse(lowered[slot].Turn));
        return Positions[slot] + Rotation.Rotate(turn, from - lowered[slot].Position);
    }

    /// <summary>Bends up the front with all that hangs on it, as far as its joints let it: what stands has been placed without that.</summary>
    private void Raise(in TrunkPlan plan, BodyLayer layer)
    {
        if (!(layer.FrontPitch > 0f) || !body.Front.Exists)
        {
            return;
        }

        IsRaised = true;
        Vector3 each = body.Front.Within(body.Bends, body.ForeSlot, new Vector3(plan.BendPitch, plan.BendYaw, plan.BendRoll), new Vector3(-layer.FrontPitch, layer.FrontSide, 0f));
        FrontTurn = AxisRotation.YawPitchRoll(each.Y, each.X, each.Z);
        for (int i = body.Front.Slot; i < Turns.Length; i++)
        {
            lowered[i] = (Turns[i], Positions[i]);
        }

        for (int i = body.Front.Slot + 1; i < Turns.Length; i++)
        {
            Positions[i] = Positions[i - 1] + Rotation.Rotate(Turns[i - 1], Rest[i] - Rest[i - 1]);
            Turns[i] = Rotation.Multiply(Turns[i - 1], LocalTurn(i));
        }
    }

    /// <summary>Turns and moves the placed chain as a whole: to a side and about its length in its middle, nose up about the hips, nose down about the joint of the fore legs.</summary>
    private void Move(BodyLayer layer)
    {
        Vector3 hips = Positions[0];
        Vector3 shoulders = Positions[body.ForeSlot];
        Vector3 middle = body.IsBiped ? hips : (hips + shoulders) * 0.5f;
        Turn(middle, AxisRotation.YawPitchRoll(layer.Yaw, 0f, layer.Roll), layer.Way);
        if (layer.Pitch != 0f)
        {
            Turn(layer.Pitch > 0f || body.IsBiped ? Positions[0] : Positions[body.ForeSlot], AxisRotation.Pitch(-layer.Pitch), Vector3.Zero);
        }
    }

    private void Turn(Vector3 pivot, Quaternion turn, Vector3 way)
    {
        for (int i = 0; i < Turns.Length; i++)
        {
            Turns[i] = Rotation.Multiply(turn, Turns[i]);
            Positions[i] = pivot + Rotation.Rotate(turn, Positions[i] - pivot) + way;
        }
    }

    /// <summary>The turn of a joint relative to the one before.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Quaternion LocalTurn(int slot)
    {
        Quaternion turn = slot <= body.ForeSlot ? Bend : Quaternion.Identity;
        if (IsRaised && slot > body.Front.Slot && slot <= body.ForeSlot)
        {
            turn = Rotation.Multiply(turn, FrontTurn);
        }

        return slot == Turns.Length - 1 ? Rotation.Multiply(turn, ChestTurn) : turn;
    }
}
