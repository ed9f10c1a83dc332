using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Json;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>What glTF has no place for, as extras of the nodes: colliders, limbs, mass, sockets.</summary>
internal static class CreatureExtras
{
    /// <summary>Writes the extras of a joint if it has any: its capsules, in its own space, and on the root joint what belongs to the whole creature, in model space, and more.</summary>
    public static void WriteJoint(JsonWriter json, Creature creature, int index, Action more)
    {
        bool carries = false;
        foreach (CapsuleCollider capsule in creature.Bones)
        {
            carries |= capsule.Joint == index;
        }

        if (index != 0 && !carries)
        {
            return;
        }

        json.Name("extras").BeginObject();
        if (carries)
        {
            json.Name("colliders").BeginArray();
            foreach (CapsuleCollider capsule in creature.Bones)
            {
                if (capsule.Joint == index)
                {
                    WriteCapsule(json, capsule);
                }
            }

            json.EndArray();
        }

        if (index == 0)
        {
            WriteWhole(json, creature);
            more();
        }

        json.EndObject();
    }

    /// <summary>Writes the extras of an attachment point: the outward direction of the skin in model space, and the width of the body there.</summary>
    public static void WriteAttachmentPoint(JsonWriter json, AttachmentPoint point)
    {
        json.Name("extras").BeginObject();
        json.Name("socket").BeginObject();
        json.Name("normal").Vector(point.Normal);
        json.Name("width").Number(point.Width);
        json.EndObject();
        json.EndObject();
    }

    private static void WriteWhole(JsonWriter json, Creature creature)
    {
        json.Name("body");
        WriteCapsule(json, creature.Body);
        json.Name("limbs").BeginArray();
        foreach (LimbChain limb in creature.Limbs)
        {
            WriteLimb(json, limb, creature.Skeleton.Joints);
        }

        json.EndArray();
        json.Name("massProperties").BeginObject();
        json.Name("mass").Number(creature.Mass.Mass);
        json.Name("volume").Number(creature.Mass.Volume);
        json.Name("centre").Vector(creature.Mass.Centre);
        json.Name("inertiaDiagonal").Vector(creature.Mass.InertiaDiagonal);
        json.Name("inertiaProducts").Vector(creature.Mass.InertiaProducts);
        json.EndObject();
        json.Name("standingHeight").Number(creature.StandingHeight);
        json.Name("defaultSpeed").Number(creature.DefaultSpeed);
    }

    private static void WriteCapsule(JsonWriter json, CapsuleCollider capsule)
    {
        json.BeginObject();
        json.Name("shape").Text("capsule");
        json.Name("radius").Number(capsule.Radius);
        json.Name("start").Vector(capsule.Start);
        json.Name("end").Vector(capsule.End);
        json.EndObject();
    }

    private static void WriteLimb(JsonWriter json, LimbChain limb, IReadOnlyList<Joint> joints)
    {
        json.BeginObject();
        json.Name("kind").Text(ExtrasNames.Limb.NameOf(limb.Kind)!);
        json.Name("side").Text(ExtrasNames.Side.NameOf(limb.Side)!);
        json.Name("pair").Number(limb.Pair);
        json.Name("joints").BeginArray();
        foreach (int joint in limb.Joints)
        {
            json.Text(joints[joint].Name);
        }

        json.EndArray();
        json.Name("pole").Vector(limb.Pole);
        json.Name("contact").Vector(limb.Contact);
        json.Name("stands").Boolean(limb.Stands);
        json.EndObject();
    }
}
