using FastPoints.Surface;
using UnityEngine;

namespace FastPoints.Samples.WalkOnAScan
{
    /// <summary>Walks to and fro on a scan, by Physics alone: a body with a velocity. It waits until there is ground.</summary>
    [RequireComponent(typeof(Rigidbody))]
    [AddComponentMenu("FastPoints/Samples/Walker")]
    public sealed class Walker : MonoBehaviour
    {
        public PointCloudCollider Ground;

        [Tooltip("In metres a second.")]
        public Vector3 Velocity = new Vector3(1.5f, 0, 0);

        [Range(1, 200)]
        [Tooltip("After so many seconds it turns round.")]
        public float Seconds = 40;

        float m_walked;

        void FixedUpdate()
        {
            var body = GetComponent<Rigidbody>();
            // Without ground it would fall for ever.
            body.isKinematic = !Ground.IsReady(transform.position);
            if (body.isKinematic)
                return;
            body.constraints = RigidbodyConstraints.FreezeRotation;
            m_walked += Time.deltaTime;
            var velocity = m_walked % (2 * Seconds) < Seconds ? Velocity : Velocity * -1;
            body.linearVelocity = new Vector3(velocity.x, body.linearVelocity.y, velocity.z);
        }

        void OnGUI() => GUILayout.Label(Ground.Error ?? Ground.CellCount + " cells, " + Ground.TriangleCount + " triangles");
    }
}
