using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Gltf;

/// <summary>Builds the joints of a <see cref="SampleCreature"/> from their places in the model; local +Y points at the main child.</summary>
internal sealed class SampleSkeleton
{
    private readonly List<(string Name, JointRole Role, Side Side, int Parent, Vector3 Position, Vector3 Towards)> drafts = new();

    /// <summary>Adds a joint that points at <paramref name="towards"/> and returns its number.</summary>
    public int Add(string name, JointRole role, Side side, int parent, Vector3 position, Vector3 towards)
    {
        drafts.Add((name, role, side, parent, position, towards));
        return drafts.Count - 1;
    }

    public Skeleton Build()
    {
        var joints = new List<Joint>();
        foreach (var draft in drafts)
        {
            Vector3 along = draft.Towards - draft.Position;
            Quaternion rotation = along.Length() > 1e-6f ? UpTo(Vector3.Normalize(along)) : draft.Parent < 0 ? Quaternion.Identity : joints[draft.Parent].ModelRotation;
            Vector3 localPosition = draft.Position;
            Quaternion localRotation = rotation;
            if (draft.Parent >= 0)
            {
                Quaternion toParent = Quaternion.Conjugate(joints[draft.Parent].ModelRotation);
                localPosition = Vector3.Transform(draft.Position - joints[draft.Parent].ModelPosition, toParent);
                localRotation = Quaternion.Normalize(toParent * rotation);
            }

            joints.Add(new Joint(draft.Name, draft.Role, draft.Side, draft.Parent, localPosition, localRotation, draft.Position, rotation, along.Length(), new JointLimit(1f, 1f, 0.5f)));
        }

        return new Skeleton(joints);
    }

    private static Quaternion UpTo(Vector3 direction)
    {
        float w = 1f + direction.Y;
        return w < 1e-6f ? new Quaternion(0f, 0f, 1f, 0f) : Quaternion.Normalize(new Quaternion(direction.Z, 0f, -direction.X, w));
    }
}
