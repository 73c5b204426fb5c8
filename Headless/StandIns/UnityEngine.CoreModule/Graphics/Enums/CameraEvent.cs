namespace UnityEngine.Rendering;

public enum CameraEvent { AfterForwardOpaque = 11 }
