using CreatureGen.Motion;
using UnityEngine;

namespace CreatureGen.Unity
{
    /// <summary>The colliders of the scene as ground to walk on.</summary>
    public sealed class PhysicsGround : IGround
    {
        private readonly LayerMask layers;

        public PhysicsGround(LayerMask layers) => this.layers = layers;

        public bool Cast(System.Numerics.Vector3 origin, System.Numerics.Vector3 direction, float distance, out GroundHit hit)
        {
            if (Physics.Raycast(UnitySpace.Point(origin), UnitySpace.Point(direction), out RaycastHit met, distance, layers, QueryTriggerInteraction.Ignore))
            {
                hit = new GroundHit(UnitySpace.Point(met.point), UnitySpace.Point(met.normal));
                return true;
            }

            hit = default;
            return false;
        }
    }
}
