using UnityEngine;

namespace Unity.Entities;

public abstract class Baker<TAuthoringType> : IBaker where TAuthoringType : Component
{
    public abstract void Bake(TAuthoringType authoring);
}
