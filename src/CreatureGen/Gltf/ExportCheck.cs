using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>Checks all of a creature but its vertex buffers, which are checked while they are written.</summary>
internal static class ExportCheck
{
    /// <summary>Finds the first defect.</summary>
    /// <exception cref="InvalidOperationException">There is one; the message says what and where.</exception>
    public static void Require(Creature creature)
    {
        if (creature.Mesh.Triangles.Length == 0)
        {
            throw ExportError.At("the mesh", "it has no triangle", "at least one");
        }

        if (creature.Skeleton.Joints.Count > ushort.MaxValue)
        {
            throw ExportError.At("the skeleton", FormattableString.Invariant($"it has {creature.Skeleton.Joints.Count} joints"), FormattableString.Invariant($"1..{ushort.MaxValue}"));
        }

        RequireAttachmentPoints(creature);
        RequireLimbs(creature);
        int joints = creature.Skeleton.Joints.Count;
        RequireCapsule(creature.Body, joints, "the body's capsule");
        for (int i = 0; i < creature.Bones.Count; i++)
        {
            RequireCapsule(creature.Bones[i], joints, FormattableString.Invariant($"capsule {i}"));
        }

        MassProperties mass = creature.Mass;
        RequirePositive(mass.Mass, "the mass");
        RequirePositive(mass.Volume, "the volume");
        RequireFinite(mass.Centre, "the centre of mass");
        RequireFinite(mass.InertiaDiagonal, "the moments of inertia");
        RequireFinite(mass.InertiaProducts, "the products of inertia");
        RequirePositive(creature.StandingHeight, "the standing height");
        if (!(float.IsFinite(creature.DefaultSpeed) && creature.DefaultSpeed >= 0f))
        {
            throw ExportError.At("the default speed", FormattableString.Invariant($"it is {creature.DefaultSpeed}"), "a finite number that is not negative");
        }
    }

    private static void RequireAttachmentPoints(Creature creature)
    {
        var names = new HashSet<string>(StringComparer.Ordinal);
        for (int level = 0; level < CreatureLods.Fractions.Count; level++)
        {
            names.Add(NodeTree.NameOfLevel(level));
        }

        foreach (Joint joint in creature.Skeleton.Joints)
        {
            RequireNew(joint.Name, names, "joint " + joint.Name);
        }

        foreach (AttachmentPoint point in creature.AttachmentPoints)
        {
            string where = "attachment point " + point.Name;
            RequireNew(point.Name, names, where);
            RequireJoint(point.Joint, creature.Skeleton.Joints.Count, where);
            RequireFinite(point.Position, where + ", position");
            if (!(Math.Abs(Vec.Length(point.Normal) - 1f) <= Tolerance.UnitLength))
            {
                throw ExportError.At(where, "its normal is " + ExportError.Text(point.Normal), "a unit vector");
            }

            RequirePositive(point.Width, where + ", width");
        }
    }

    private static void RequireLimbs(Creature creature)
    {
        for (int i = 0; i < creature.Limbs.Count; i++)
        {
            LimbChain limb = creature.Limbs[i];
            string where = FormattableString.Invariant($"limb {i}");
            if (ExtrasNames.Limb.NameOf(limb.Kind) is null || ExtrasNames.Side.NameOf(limb.Side) is null)
            {
                throw ExportError.At(where, FormattableString.Invariant($"its kind is {(int)limb.Kind} and its side {(int)limb.Side}"), "defined values");
            }

            foreach (int joint in limb.Joints)
            {
                RequireJoint(joint, creature.Skeleton.Joints.Count, where);
            }

            RequireFinite(limb.Pole, where + ", pole");
            RequireFinite(limb.Contact, where + ", contact");
        }
    }

    private static void RequireCapsule(CapsuleCollider capsule, int jointCount, string where)
    {
        RequireJoint(capsule.Joint, jointCount, where);
        RequireFinite(capsule.Start, where + ", start");
        RequireFinite(capsule.End, where + ", end");
        RequirePositive(capsule.Radius, where + ", radius");
    }

    private static void RequireNew(string name, HashSet<string> names, string where)
    {
        foreach (char c in name)
        {
            if (!(c is (>= 'A' and <= 'Z') or (>= 'a' and <= 'z') or (>= '0' and <= '9') or '_'))
            {
                throw ExportError.At(where, "its name has other characters than importers keep", "letters, digits and underscores");
            }
        }

        if (name.Length == 0 || !names.Add(name))
        {
            throw ExportError.At(where, name.Length == 0 ? "it has no name" : "another node has the same name", "a name of its own");
        }
    }

    private static void RequireJoint(int joint, int jointCount, string where)
    {
        if ((uint)joint >= (uint)jointCount)
        {
            throw ExportError.At(where, FormattableString.Invariant($"it refers to joint {joint}"), FormattableString.Invariant($"0..{jointCount - 1}"));
        }
    }

    private static void RequireFinite(Vector3 v, string where)
    {
        if (!(float.IsFinite(v.X) && float.IsFinite(v.Y) && float.IsFinite(v.Z)))
        {
            throw ExportError.At(where, "it is " + ExportError.Text(v), "finite numbers");
        }
    }

    private static void RequirePositive(float x, string where)
    {
        if (!(float.IsFinite(x) && x > 0f))
        {
            throw ExportError.At(where, FormattableString.Invariant($"it is {x}"), "a finite positive number");
        }
    }
}
