namespace UnityEngine;

[Flags]
public enum RigidbodyConstraints
{
    None = 0,
    FreezePositionX = 2,
    FreezePositionY = 4,
    FreezePositionZ = 8,
    FreezeRotationX = 16,
    FreezeRotationY = 32,
    FreezeRotationZ = 64,
    FreezePosition = 14,
    FreezeRotation = 112,
    FreezeAll = 126,
}

/// <summary>Nothing moves it here.</summary>
public class Rigidbody : Component
{
    bool m_isKinematic;
    Vector3 m_velocity;
    RigidbodyConstraints m_constraints;

    public bool isKinematic
    {
        get => There(m_isKinematic);
        set
        {
            CheckIsThere();
            m_isKinematic = value;
        }
    }

    public Vector3 linearVelocity
    {
        get => There(m_velocity);
        set
        {
            CheckIsThere();
            m_velocity = value;
        }
    }

    public RigidbodyConstraints constraints
    {
        get => There(m_constraints);
        set
        {
            CheckIsThere();
            m_constraints = value;
        }
    }
}
